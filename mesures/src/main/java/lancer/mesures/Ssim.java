package lancer.mesures;

/**
 * La ressemblance de deux images telle qu'un œil la juge : SSIM, de Z. Wang, A. Bovik, H. Sheikh et E. Simoncelli, <i>Image
 * Quality Assessment: From Error Visibility to Structural Similarity</i>, IEEE Transactions on Image Processing 13(4), 2004,
 * équations 13 à 17, avec la fenêtre de l'article (11 × 11, gaussienne d'écart type 1,5 pixel) et ses constantes (K1 = 0,01,
 * K2 = 0,03).
 *
 * <p>Ce qui est simplifié : une seule valeur par pixel, la luminance 0,2126 R + 0,7152 V + 0,0722 B des couleurs limitées à
 * [0, 1] (sans arrondi à 256 niveaux, la dynamique valant 1) ; une seule échelle, celle de l'image ; seules comptent les fenêtres
 * tout entières dans l'image.
 */
final class Ssim {

    /** Côté de la fenêtre, en pixels. */
    static final int FENETRE = 11;

    private static final double ECART_TYPE = 1.5;
    private static final double C1 = 0.01 * 0.01;
    private static final double C2 = 0.03 * 0.03;
    private static final double[] POIDS = poids();

    private Ssim() {
    }

    /**
     * @param a de mêmes dimensions que {@code b}, {@value #FENETRE} pixels de côté au moins
     * @return 1 si les luminances sont les mêmes, sinon moins
     */
    static double entre(ImageLineaire a, ImageLineaire b) {
        int largeur = a.getLargeur();
        int hauteur = a.getHauteur();
        if (largeur < FENETRE || hauteur < FENETRE) {
            throw new IllegalArgumentException("image de moins de " + FENETRE + " pixels de côté : " + largeur + " × " + hauteur);
        }
        double[] x = luminances(a);
        double[] y = luminances(b);
        double[] mx = flou(x, largeur, hauteur);
        double[] my = flou(y, largeur, hauteur);
        double[] xx = flou(produit(x, x), largeur, hauteur);
        double[] yy = flou(produit(y, y), largeur, hauteur);
        double[] xy = flou(produit(x, y), largeur, hauteur);
        double somme = 0;
        for (int k = 0; k < mx.length; k++) {
            double covariance = xy[k] - mx[k] * my[k];
            double variances = (xx[k] - mx[k] * mx[k]) + (yy[k] - my[k] * my[k]);
            somme += (2 * mx[k] * my[k] + C1) * (2 * covariance + C2)
                    / ((mx[k] * mx[k] + my[k] * my[k] + C1) * (variances + C2));
        }
        return somme / mx.length;
    }

    private static double[] luminances(ImageLineaire image) {
        double[] c = image.getComposantes();
        double[] luminances = new double[c.length / 3];
        for (int k = 0; k < luminances.length; k++) {
            luminances[k] = 0.2126 * limite(c[3 * k]) + 0.7152 * limite(c[3 * k + 1]) + 0.0722 * limite(c[3 * k + 2]);
        }
        return luminances;
    }

    private static double limite(double x) {
        return Math.max(0, Math.min(1, x));
    }

    private static double[] produit(double[] x, double[] y) {
        double[] produit = new double[x.length];
        for (int k = 0; k < x.length; k++) {
            produit[k] = x[k] * y[k];
        }
        return produit;
    }

    /** La moyenne pondérée de chaque fenêtre entière : par lignes, puis par colonnes. */
    private static double[] flou(double[] x, int largeur, int hauteur) {
        int l = largeur - FENETRE + 1;
        int h = hauteur - FENETRE + 1;
        double[] lignes = new double[l * hauteur];
        for (int j = 0; j < hauteur; j++) {
            for (int i = 0; i < l; i++) {
                for (int d = 0; d < FENETRE; d++) {
                    lignes[j * l + i] += POIDS[d] * x[j * largeur + i + d];
                }
            }
        }
        double[] flou = new double[l * h];
        for (int j = 0; j < h; j++) {
            for (int i = 0; i < l; i++) {
                for (int d = 0; d < FENETRE; d++) {
                    flou[j * l + i] += POIDS[d] * lignes[(j + d) * l + i];
                }
            }
        }
        return flou;
    }

    private static double[] poids() {
        double[] poids = new double[FENETRE];
        double somme = 0;
        for (int d = 0; d < FENETRE; d++) {
            double ecart = (d - FENETRE / 2) / ECART_TYPE;
            poids[d] = Math.exp(-ecart * ecart / 2);
            somme += poids[d];
        }
        for (int d = 0; d < FENETRE; d++) {
            poids[d] /= somme;
        }
        return poids;
    }
}
