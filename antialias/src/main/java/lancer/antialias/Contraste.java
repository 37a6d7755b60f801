package lancer.antialias;

import lancer.Couleur;

/** Ce qui sépare des couleurs telles qu'on les verra, donc limitées à [0, 1]. */
final class Contraste {

    private Contraste() {
    }

    /** Le plus grand écart entre quatre couleurs limitées, sur une composante : de 0 à 1. */
    static double entre(Couleur a, Couleur b, Couleur c, Couleur d) {
        return Math.max(etendue(a.r, b.r, c.r, d.r),
                Math.max(etendue(a.v, b.v, c.v, d.v), etendue(a.b, b.b, c.b, d.b)));
    }

    /** Sans Math.min ni Math.max, dont le soin pour NaN et −0.0 doublerait le temps de la méthode. */
    private static double etendue(double a, double b, double c, double d) {
        double minAB = a < b ? a : b;
        double maxAB = a < b ? b : a;
        double minCD = c < d ? c : d;
        double maxCD = c < d ? d : c;
        return limite(maxAB < maxCD ? maxCD : maxAB) - limite(minAB < minCD ? minAB : minCD);
    }

    private static double limite(double x) {
        return x < 0 ? 0 : x > 1 ? 1 : x;
    }
}
