package lancer.image;

import java.util.stream.IntStream;
import lancer.Couleur;

/** Réduction d'une image : chaque pixel réduit est la moyenne de la surface qu'il couvre. */
public final class Reduction {

    private Reduction() {
    }

    /** Les codes, 0 sans dessin. @param pas 1 pour la moyenne exacte ; n pour lire une ligne et une colonne sur n */
    public static int[] moyenne(ImageMemoire image, int largeur, int hauteur, int pas) {
        int[] codes = new int[largeur * hauteur];
        IntStream.range(0, hauteur).parallel().forEach(y -> reduireLigne(image, largeur, hauteur, y, pas, codes));
        return codes;
    }

    private static void reduireLigne(ImageMemoire image, int largeur, int hauteur, int y, int pas, int[] codes) {
        double fx = (double) image.largeur / largeur;
        double haut = (double) y * image.hauteur / hauteur;
        double bas = (y + 1.0) * image.hauteur / hauteur;
        for (int x = 0; x < largeur; x++) {
            double gauche = x * fx;
            double droite = Math.min(image.largeur, gauche + fx);
            double r = 0;
            double v = 0;
            double b = 0;
            double total = 0;
            for (int j = (int) haut; j < bas && j < image.hauteur; j += pas) {
                double poidsJ = Math.min(j + 1, bas) - Math.max(j, haut);
                for (int i = (int) gauche; i < droite; i += pas) {
                    int code = image.codes[j * image.largeur + i];
                    double poids = code == 0 ? 0 : poidsJ * (Math.min(i + 1, droite) - Math.max(i, gauche));
                    r += poids * (code >> 16 & 255);
                    v += poids * (code >> 8 & 255);
                    b += poids * (code & 255);
                    total += poids;
                }
            }
            codes[y * largeur + x] = total == 0 ? 0 : new Couleur(r, v, b).div(255 * total).getCode();
        }
    }
}
