package lancer.antialias;

import lancer.Couleur;

/** Ce qui sépare des couleurs telles qu'on les verra, donc limitées à [0, 1]. */
final class Contraste {

    private Contraste() {
    }

    /** Le plus grand écart entre quatre couleurs limitées, sur une composante : de 0 à 1. */
    static double entre(Couleur a, Couleur b, Couleur c, Couleur d) {
        return Math.max(etendue(a.r, b.r, c.r, d.r), Math.max(etendue(a.v, b.v, c.v, d.v), etendue(a.b, b.b, c.b, d.b)));
    }

    private static double etendue(double a, double b, double c, double d) {
        double min = Math.min(Math.min(a, b), Math.min(c, d));
        double max = Math.max(Math.max(a, b), Math.max(c, d));
        return limite(max) - limite(min);
    }

    private static double limite(double x) {
        return Math.max(0, Math.min(1, x));
    }
}
