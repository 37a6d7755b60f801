package lancer.antialias;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntPredicate;
import lancer.Camera;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;
import lancer.Vecteur;

/**
 * Les boules trop petites à l'écran pour qu'un point par pixel les voie toutes : où elles sont, et leur rayon, se
 * calcule avant de dessiner. Ni l'ombre ni le reflet d'une boule n'y sont. Immuable.
 */
final class Petites {

    /** Le rayon au-dessous duquel un disque peut passer entre les points d'une trame, en pas de cette trame. */
    private static final double MAILLE = Math.sqrt(0.5);

    private final int largeur;
    private final int hauteur;

    /** L'abscisse, l'ordonnée et le rayon, en pixels, de chaque disque dont la boîte touche un pixel, par son rang. */
    private final Map<Integer, List<double[]>> disques = new HashMap<>();

    Petites(List<Objet3D> objets, Camera camera) {
        largeur = camera.getLargeur();
        hauteur = camera.getHauteur();
        for (Objet3D objet : objets) {
            if (objet instanceof Sphere) {
                projeter((Sphere) objet, camera);
            }
        }
    }

    /** Projette une sphère de rayon r, à un angle θ de l'axe et à la distance D : son demi-axe est F r/(D cos²θ). */
    private void projeter(Sphere sphere, Camera camera) {
        Vecteur c = new Vecteur(camera.getOeil(), sphere.getCentre());
        Point vu = camera.projeter(sphere.getCentre());
        double r = sphere.getRayon() * vu.z * Math.sqrt(1 + (c.x * c.x + c.y * c.y) / (c.z * c.z));
        if (sphere.getCentre().z > camera.getEcran(0, 0).z && r < MAILLE && vu.x > -1 && vu.x < largeur + 1
                && vu.y > -1 && vu.y < hauteur + 1) {
            double[] disque = {vu.x, vu.y, r};
            parcourir(vu.x - r, vu.y - r, vu.x + r, vu.y + r, pixel -> {
                disques.computeIfAbsent(pixel, rang -> new ArrayList<>(1)).add(disque);
                return false;
            });
        }
    }

    /** Dit si un des pixels que touche ce rectangle répond oui : les suivants ne sont plus interrogés. */
    private boolean parcourir(double x0, double y0, double x1, double y1, IntPredicate question) {
        for (int j = Math.max(0, (int) Math.floor(y0)); j <= Math.min(hauteur - 1, (int) Math.floor(y1)); j++) {
            for (int i = Math.max(0, (int) Math.floor(x0)); i <= Math.min(largeur - 1, (int) Math.floor(x1)); i++) {
                if (question.test(j * largeur + i)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Dit si la boîte d'un disque touche ce rectangle, dont les quatre coins peuvent le manquer ; en pixels. */
    boolean peutEchapper(double x0, double y0, double x1, double y1) {
        double cote = Math.max(x1 - x0, y1 - y0);
        return !disques.isEmpty() && parcourir(x0, y0, x1, y1, pixel -> disques.containsKey(pixel)
                && disques.get(pixel).stream().anyMatch(d -> d[2] < MAILLE * cote && d[0] + d[2] > x0
                        && d[0] - d[2] < x1 && d[1] + d[2] > y0 && d[1] - d[2] < y1));
    }
}
