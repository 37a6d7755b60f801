package lancer.correction.jugement;

/** En quoi une image diffère de la référence, en niveaux de 255. */
public final class Ecart {

    /** À partir d'autant de niveaux, un pixel est faux. */
    private static final double FAUX = 2;

    /** Part de pixels faux que les arrondis, aux bords des boules et des ombres, suffisent à expliquer. */
    private static final double PART_PERMISE = 0.005;

    public final double rmse;
    public final double pire;
    public final int pireX;
    public final int pireY;
    public final int faux;
    public final int pixels;

    public Ecart(Image a, Image b) {
        double carres = 0;
        double max = -1;
        int ou = 0;
        int n = 0;
        for (int p = 0; p < a.pixels(); p++) {
            double d = ecart(a, b, p);
            for (int k = 0; k < 3; k++) {
                double e = a.niveau(p, k) - b.niveau(p, k);
                carres += e * e;
            }
            n += d > FAUX ? 1 : 0;
            if (d > max) {
                max = d;
                ou = p;
            }
        }
        rmse = Math.sqrt(carres / (3.0 * a.pixels()));
        pire = max;
        pireX = ou % a.largeur;
        pireY = ou / a.largeur;
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

    /** « 1 pixel faux », « 12 pixels faux ». */
    public String combien() {
        return faux + (faux > 1 ? " pixels faux" : " pixel faux");
    }

    /** Vrai si c'est la même image, à des arrondis près. */
    public boolean memeImage() {
        return faux <= PART_PERMISE * pixels;
    }
}
