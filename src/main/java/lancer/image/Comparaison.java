package lancer.image;

import java.util.Locale;
import lancer.Couleur;
import lancer.commande.Echec;

/**
 * Différences de deux images de même taille, limitées à [0, 1], en niveaux de 1/255. Si une image n'a que 8 bits par
 * composante, l'autre est d'abord arrondie à 8 bits.
 */
public final class Comparaison {

    private static final int PEU = 1;
    private static final int BEAUCOUP = 8;
    private static final int GROSSI = 8;

    private final ImageMemoire a;
    private final ImageMemoire b;
    private final double part;
    private final boolean surHuitBits;
    private final int pixels;
    private final double rmse;
    private double pire;
    private int ou;
    private int auDela;
    private int plusDUn;
    private int plusDeHuit;

    /**
     * @param a une image qui a ses codes ; sans couleurs non limitées, elle n'a que 8 bits par composante
     * @param tolerance le plus grand écart permis d'une composante, en niveaux
     * @param part la part des pixels, de 0 à 1, qui peuvent s'écarter davantage
     * @throws Echec si les images n'ont pas la même taille
     */
    public Comparaison(ImageMemoire a, ImageMemoire b, double tolerance, double part) {
        if (a.largeur != b.largeur || a.hauteur != b.hauteur) {
            throw Echec.demande(String.format(
                    "images de tailles différentes : %dx%d et %dx%d ; attendu : la même taille",
                    a.largeur, a.hauteur, b.largeur, b.hauteur));
        }
        this.a = a;
        this.b = b;
        this.part = part;
        surHuitBits = a.lineaire == null || b.lineaire == null;
        pixels = a.codes.length;
        double carres = 0;
        for (int p = 0; p < pixels; p++) {
            double max = 0;
            for (int k = 0; k < 3; k++) {
                double e = ecart(p, k);
                carres += e * e;
                max = Math.max(max, e);
            }
            auDela += max > tolerance ? 1 : 0;
            plusDUn += max > PEU ? 1 : 0;
            plusDeHuit += max > BEAUCOUP ? 1 : 0;
            ou = max > pire ? p : ou;
            pire = Math.max(pire, max);
        }
        rmse = Math.sqrt(carres / (3.0 * pixels));
    }

    private double ecart(int p, int k) {
        return Math.abs(niveau(a, p, k) - niveau(b, p, k));
    }

    /** Une composante limitée à [0, 1], en niveaux de 1/255. */
    private double niveau(ImageMemoire image, int p, int k) {
        return surHuitBits ? image.codes[p] >> 16 - 8 * k & 255
                : 255.0 * Math.min(1, Math.max(0, image.lineaire[3 * p + k]));
    }

    /** Dit si la part des pixels qui passent la tolérance est permise. */
    public boolean sontPareilles() {
        return (double) auDela / pixels <= part;
    }

    /** Peint en gris le plus grand écart de chaque pixel : noir s'il est nul, blanc à partir de 32 niveaux. */
    public ImageMemoire peindreLesEcarts(ImageMemoire image) {
        for (int p = 0; p < pixels; p++) {
            double max = Math.max(ecart(p, 0), Math.max(ecart(p, 1), ecart(p, 2)));
            image.drawPixel(new Couleur(GROSSI * max / 255), new Couleur(max), p % a.largeur, p / a.largeur);
        }
        return image;
    }

    /** Le verdict et les écarts, une ligne {@code nom: valeur} chacun. */
    @Override
    public String toString() {
        String verdict = "différentes";
        if (sontPareilles()) {
            verdict = "pareilles";
        } else if (pire <= PEU) {
            verdict += ", à l'arrondi près : --tolerance 1 les tient pour pareilles";
        }
        String permis = part > 0 ? String.format("%npixels au-delà de la tolérance: %d sur %d", auDela, pixels) : "";
        String place = pire > 0 ? " en " + ou % a.largeur + "," + ou / a.largeur : "";
        return String.format(Locale.ROOT, "images: %s%nécart quadratique moyen: %.4f%nplus grand écart: %.4f%s%n"
                + "pixels à plus de 1 niveau: %d sur %d%npixels à plus de 8 niveaux: %d sur %d%s",
                verdict, rmse, pire, place, plusDUn, pixels, plusDeHuit, pixels, permis);
    }
}
