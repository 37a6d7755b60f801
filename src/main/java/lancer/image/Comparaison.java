package lancer.image;

import java.util.Locale;
import java.util.stream.IntStream;
import lancer.Couleur;
import lancer.systeme.Echec;

/**
 * Différences de deux images de même taille, limitées à [0, 1], en niveaux de 1/255. Si une image n'a que 8 bits par
 * composante, l'autre est d'abord arrondie à 8 bits.
 */
public final class Comparaison {

    private final ImageMemoire a;
    private final ImageMemoire b;
    private final double tolerance;
    private final double part;
    private final int pixels;

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
        this.tolerance = tolerance;
        this.part = part;
        pixels = a.codes.length;
    }

    /** L'écart d'une composante. @param k trois fois le rang du pixel, plus celui de la composante */
    private double ecart(int k) {
        return Math.abs(niveau(a, k) - niveau(b, k));
    }

    /** Une composante limitée à [0, 1], en niveaux de 1/255. */
    private double niveau(ImageMemoire image, int k) {
        return a.lineaire == null || b.lineaire == null ? image.codes[k / 3] >> 16 - 8 * (k % 3) & 255
                : 255.0 * Math.min(1, Math.max(0, image.lineaire[k]));
    }

    /** Le plus grand écart des composantes d'un pixel. */
    private double pire(int p) {
        return Math.max(ecart(3 * p), Math.max(ecart(3 * p + 1), ecart(3 * p + 2)));
    }

    private long compterAuDela(double niveaux) {
        return IntStream.range(0, pixels).filter(p -> pire(p) > niveaux).count();
    }

    /** Dit si la part des pixels qui passent la tolérance est permise. */
    public boolean sontPareilles() {
        return (double) compterAuDela(tolerance) / pixels <= part;
    }

    /** Une image, en gris, du plus grand écart de chaque pixel : noir s'il est nul, blanc à partir de 32 niveaux. */
    public ImageMemoire peindreLesEcarts() {
        ImageMemoire image = new ImageMemoire(a.largeur, a.hauteur, false);
        for (int p = 0; p < pixels; p++) {
            image.drawPixel(new Couleur(8 * pire(p) / 255), p % a.largeur, p / a.largeur);
        }
        return image;
    }

    /** Le verdict et les écarts, une ligne {@code nom: valeur} chacun. */
    @Override
    public String toString() {
        int ou = IntStream.range(0, pixels).reduce((p, q) -> pire(q) > pire(p) ? q : p).getAsInt();
        double carre = IntStream.range(0, 3 * pixels).mapToDouble(k -> ecart(k) * ecart(k)).sum() / (3.0 * pixels);
        String place = pire(ou) > 0 ? " en " + ou % a.largeur + "," + ou / a.largeur : "";
        String permis = part == 0 ? ""
                : String.format("%npixels au-delà de la tolérance: %d sur %d", compterAuDela(tolerance), pixels);
        return String.format(Locale.ROOT, "images: %s%nécart quadratique moyen: %.4f%nplus grand écart: %.4f%s%n"
                + "pixels à plus de 1 niveau: %d sur %d%npixels à plus de 8 niveaux: %d sur %d%s",
                sontPareilles() ? "pareilles" : "différentes", Math.sqrt(carre), pire(ou), place, compterAuDela(1),
                pixels, compterAuDela(8), pixels, permis);
    }
}
