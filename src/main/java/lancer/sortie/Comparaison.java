package lancer.sortie;

import java.util.Locale;
import lancer.Couleur;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;

/**
 * En quoi deux images de même taille diffèrent, limitées à [0, 1], en niveaux de 1/255. Si l'une n'a que 8 bits par
 * composante, l'autre y est d'abord arrondie : c'est ce qu'un PNG en aurait gardé.
 */
public final class Comparaison {

    private static final int PEU = 1;
    private static final int BEAUCOUP = 8;

    private final ImageLue a;
    private final ImageLue b;
    private final double tolerance;
    private final boolean surHuitBits;
    private double rmse;
    private double pire;
    private int ou;
    private int plusDUn;
    private int plusDeHuit;

    /**
     * @param tolerance le plus grand écart permis d'une composante, en niveaux
     * @throws Echec si les images n'ont pas la même taille, ou ont une couleur qui n'est pas un nombre
     */
    public Comparaison(ImageLue a, ImageLue b, double tolerance) {
        if (a.getLargeur() != b.getLargeur() || a.getHauteur() != b.getHauteur()) {
            throw new Echec(CodeSortie.DEMANDE, "images de tailles différentes : " + a.getLargeur() + "x"
                    + a.getHauteur() + " et "
                    + b.getLargeur() + "x" + b.getHauteur() + " ; attendu : la même taille");
        }
        if (a.aUnNaN() || b.aUnNaN()) {
            throw new Echec(CodeSortie.DEMANDE,
                    "une des images a une couleur qui n'est pas un nombre (NaN) ; attendu : des nombres");
        }
        this.a = a;
        this.b = b;
        this.tolerance = tolerance;
        this.surHuitBits = a.estSurHuitBits() || b.estSurHuitBits();
        double carres = 0;
        int pixels = a.getLargeur() * a.getHauteur();
        for (int p = 0; p < pixels; p++) {
            double max = 0;
            for (int k = 0; k < 3; k++) {
                double e = ecart(p, k);
                carres += e * e;
                max = Math.max(max, e);
            }
            plusDUn += max > PEU ? 1 : 0;
            plusDeHuit += max > BEAUCOUP ? 1 : 0;
            if (max > pire) {
                pire = max;
                ou = p;
            }
        }
        rmse = Math.sqrt(carres / (3.0 * pixels));
    }

    private double ecart(int p, int k) {
        if (surHuitBits) {
            int decalage = 16 - 8 * k;
            return Math.abs((a.code(p) >> decalage & 255) - (b.code(p) >> decalage & 255));
        }
        return Math.abs(a.niveau(3 * p + k) - b.niveau(3 * p + k));
    }

    /** Vrai si aucune composante ne s'écarte plus que permis. */
    public boolean pareilles() {
        return pire <= tolerance;
    }

    /**
     * Les différences : noir où les images sont pareilles, et d'autant plus clair qu'elles diffèrent, jusqu'à huit
     * niveaux.
     */
    public ImageMemoire getDifferences() {
        ImageMemoire image = new ImageMemoire(a.getLargeur(), a.getHauteur(), false);
        for (int p = 0; p < a.getLargeur() * a.getHauteur(); p++) {
            Couleur ecarts = new Couleur(ecart(p, 0), ecart(p, 1), ecart(p, 2)).div(BEAUCOUP);
            image.drawPixel(ecarts, p % a.getLargeur(), p / a.getLargeur());
        }
        return image;
    }

    /** Ce qu'il y a à en dire, une ligne {@code nom: valeur} chacun. */
    @Override
    public String toString() {
        String place = pire > 0 ? " en " + ou % a.getLargeur() + "," + ou / a.getLargeur() : "";
        return String.format(Locale.ROOT, "images: %s%nécart quadratique moyen: %.4f%nplus grand écart: %.4f%s%n"
                + "pixels à plus de 1 niveau: %d sur %d%npixels à plus de 8 niveaux: %d sur %d", pareilles()
                ? "pareilles" : "différentes", rmse, pire, place,
                plusDUn, a.getLargeur() * a.getHauteur(), plusDeHuit, a.getLargeur() * a.getHauteur());
    }
}
