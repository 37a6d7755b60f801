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
import lancer.contrat.Pave;

/**
 * Les sphères trop petites à l'écran pour qu'un point par pixel les voie toutes. Leur position et leur rayon à l'écran
 * sont calculés avant le dessin. Leurs ombres et leurs reflets n'y sont pas. Immuable.
 */
final class Petites {

    /** Rayon, en pas d'une grille de points, au-dessous duquel un disque peut passer entre les points. */
    private static final double MAILLE = Math.sqrt(0.5);

    private final int largeur;
    private final int hauteur;

    /** Par pixel, les ellipses dont la boîte le touche : centre, demi-côtés de la boîte, rayon de courbure au bout. */
    private final Map<Integer, List<double[]>> ellipses = new HashMap<>();

    Petites(List<Objet3D> objets, Camera camera) {
        largeur = camera.getLargeur();
        hauteur = camera.getHauteur();
        for (Objet3D objet : objets) {
            if (objet instanceof Sphere) {
                projeter((Sphere) objet, camera);
            }
        }
    }

    /**
     * Projette une sphère de rayon r, à la distance D et à l'angle θ de l'axe. Le petit demi-axe de l'ellipse est F
     * r/(D cos θ). Le rayon de courbure de ses bouts, F r/D, dit si un bout peut passer entre les points. Une ellipse
     * plus longue qu'un pavé est ignorée.
     */
    private void projeter(Sphere sphere, Camera camera) {
        Vecteur c = camera.depuisLOeil(sphere.getCentre());
        Point vu = camera.projeter(sphere.getCentre());
        double r = sphere.getRayon() * vu.z;
        double x = r * Math.hypot(1, c.x / c.z);
        double y = r * Math.hypot(1, c.y / c.z);
        if (c.z > camera.depuisLOeil(camera.getEcran(0, 0)).z && r < MAILLE && Math.max(x, y) < Pave.COTE && vu.x > -1
                && vu.x < largeur + 1 && vu.y > -1 && vu.y < hauteur + 1) {
            double[] ellipse = {vu.x, vu.y, x, y, r * c.z / c.norme()};
            parcourir(vu.x - x, vu.y - y, vu.x + x, vu.y + y, pixel -> {
                ellipses.computeIfAbsent(pixel, rang -> new ArrayList<>(1)).add(ellipse);
                return false;
            });
        }
    }

    /** Dit si {@code question} est vraie d'un pixel que touche ce rectangle. */
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

    /** Dit si la boîte d'une ellipse touche ce rectangle, en pixels, sans que ses coins la voient à coup sûr. */
    boolean peutEchapper(double x0, double y0, double x1, double y1) {
        double cote = Math.max(x1 - x0, y1 - y0);
        return !ellipses.isEmpty() && parcourir(x0, y0, x1, y1, pixel -> ellipses.containsKey(pixel)
                && ellipses.get(pixel).stream().anyMatch(e -> e[4] < MAILLE * cote && e[0] + e[2] > x0
                        && e[0] - e[2] < x1 && e[1] + e[3] > y0 && e[1] - e[3] < y1));
    }
}
