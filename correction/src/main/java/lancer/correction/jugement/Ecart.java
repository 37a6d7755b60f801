package lancer.correction.jugement;

/** En quoi une image diffère de la référence, en niveaux de 255. */
public final class Ecart {

    /** À partir d'autant de niveaux, un pixel est faux. */
    private static final double FAUX = 2;

    /** Part de pixels faux que les arrondis, aux bords des boules et des ombres, suffisent à expliquer. */
    private static final double PART_PERMISE = 0.005;

    /** Le rang du pixel le plus faux. */
    final int pire;
    private final int faux;
    private final int pixels;

    public Ecart(Image a, Image b) {
        double max = -1;
        int ou = 0;
        int n = 0;
        for (int p = 0; p < a.pixels(); p++) {
            double d = ecart(a, b, p);
            n += d > FAUX ? 1 : 0;
            ou = d > max ? p : ou;
            max = Math.max(d, max);
        }
        pire = ou;
        faux = n;
        pixels = a.pixels();
    }

    static double ecart(Image a, Image b, int pixel) {
        double d = 0;
        for (int k = 0; k < 3; k++) {
            d = Math.max(d, Math.abs(a.niveau(pixel, k) - b.niveau(pixel, k)));
        }
        return d;
    }

    /** « 1 pixel faux sur 4800 », « 12 pixels faux sur 4800 ». */
    public String combien() {
        return faux + (faux > 1 ? " pixels faux" : " pixel faux") + " sur " + pixels;
    }

    /** Vrai si c'est la même image, à des arrondis près. */
    public boolean memeImage() {
        return faux <= PART_PERMISE * pixels;
    }
}
