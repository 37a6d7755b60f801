package lancer.antialias;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;

/**
 * Les boules trop petites à l'écran pour qu'un point par pixel les voie toutes : où elles sont, et leur rayon, se
 * calcule avant de dessiner. Ni l'ombre ni le reflet d'une boule n'y sont. Immuable.
 */
final class Petites {

    static final Petites AUCUNE = new Petites(Collections.emptyList(), new Camera(1, 1));

    /** Le rayon au-dessous duquel un disque peut passer entre les points d'une trame, en pas de cette trame. */
    private static final double MAILLE = Math.sqrt(0.5);

    private final int largeur;
    private final int hauteur;

    /** Abscisse, ordonnée et rayon de chaque disque, en pixels. */
    private final double[] disques;

    /** Par pixel, ligne par ligne, où commencent ses disques dans {@link #rangs} ; puis où finissent les derniers. */
    private final int[] debuts;
    private int[] rangs;

    Petites(List<Objet3D> objets, Camera camera) {
        largeur = camera.getLargeur();
        hauteur = camera.getHauteur();
        debuts = new int[largeur * hauteur + 1];
        double[] places = new double[3 * objets.size()];
        int taille = 0;
        for (Objet3D objet : objets) {
            taille += objet instanceof Sphere && projeter((Sphere) objet, places, taille) ? 3 : 0;
        }
        disques = Arrays.copyOf(places, taille);
        ranger();
    }

    /** Projette une sphère de rayon r, à un angle θ de l'axe et à la distance D : son demi-axe est F r/(D cos²θ). */
    private boolean projeter(Sphere sphere, double[] disques, int k) {
        Point c = sphere.getCentre();
        double profondeur = c.z + Camera.FOCALE;
        double echelle = Camera.FOCALE / profondeur * largeur / Constantes.ECHELLE;
        double rayon = sphere.getRayon() * echelle * Math.sqrt(1 + (c.x * c.x + c.y * c.y) / (profondeur * profondeur));
        disques[k] = largeur / 2.0 + c.x * echelle;
        disques[k + 1] = hauteur / 2.0 - c.y * echelle;
        disques[k + 2] = rayon;
        return c.z > 0 && rayon < MAILLE && disques[k] > -1 && disques[k] < largeur + 1 && disques[k + 1] > -1
                && disques[k + 1] < hauteur + 1;
    }

    /** Range chaque disque dans les pixels que sa boîte touche : les compte, puis les note, du dernier au premier. */
    private void ranger() {
        for (int passe = 0; passe < 2; passe++) {
            for (int d = 0; d < disques.length; d += 3) {
                double r = disques[d + 2];
                int bas = Math.min(hauteur - 1, bord(disques[d + 1] + r));
                int droite = Math.min(largeur - 1, bord(disques[d] + r));
                for (int j = bord(disques[d + 1] - r); j <= bas; j++) {
                    for (int k = j * largeur + bord(disques[d] - r); k <= j * largeur + droite; k++) {
                        if (passe == 0) {
                            debuts[k]++;
                        } else {
                            rangs[--debuts[k]] = d;
                        }
                    }
                }
            }
            for (int k = 1; k < debuts.length && passe == 0; k++) {
                debuts[k] += debuts[k - 1];
            }
            rangs = passe == 0 ? new int[debuts[debuts.length - 1]] : rangs;
        }
    }

    private static int bord(double x) {
        return Math.max(0, (int) Math.floor(x));
    }

    /** Dit si la boîte d'un disque touche ce rectangle, dont les quatre coins peuvent le manquer ; en pixels. */
    boolean peutEchapper(double x0, double y0, double x1, double y1) {
        double cote = Math.max(x1 - x0, y1 - y0);
        for (int j = bord(y0); j <= Math.min(hauteur - 1, bord(y1)); j++) {
            for (int i = bord(x0); i <= Math.min(largeur - 1, bord(x1)); i++) {
                for (int k = debuts[j * largeur + i]; k < debuts[j * largeur + i + 1]; k++) {
                    int d = rangs[k];
                    double r = disques[d + 2];
                    if (r < MAILLE * cote && disques[d] + r > x0 && disques[d] - r < x1 && disques[d + 1] + r > y0
                            && disques[d + 1] - r < y1) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    boolean estVide() {
        return disques.length == 0;
    }
}
