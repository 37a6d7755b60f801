package lancer.essai;

import static lancer.precision.IntersectionCompensee.reste;

/**
 * Un nombre de 106 bits, somme de deux doubles (Dekker, <i>A floating-point technique for extending the available precision</i>,
 * Numerische Mathematik 18, 1971) : ce que coûterait de tout calculer ainsi. Immuable.
 */
final class DeuxDoubles {

    /** 2²⁷ + 1 : coupe un double en deux moitiés dont les produits tombent juste. */
    private static final double COUPE = 0x1p27 + 1;

    final double haut;
    private final double bas;

    private DeuxDoubles(double haut, double bas) {
        this.haut = haut;
        this.bas = bas;
    }

    private static DeuxDoubles somme(double haut, double bas) {
        double s = haut + bas;
        return new DeuxDoubles(s, reste(haut, bas, s));
    }

    /** a − b, sans erreur. */
    static DeuxDoubles difference(double a, double b) {
        return somme(a, -b);
    }

    /** x², sans erreur. */
    static DeuxDoubles carre(double x) {
        return new DeuxDoubles(x * x, perte(x, x));
    }

    /** Ce que l'arrondi du produit a perdu, exactement. */
    private static double perte(double x, double y) {
        double xh = COUPE * x - (COUPE * x - x);
        double yh = COUPE * y - (COUPE * y - y);
        double xb = x - xh;
        double yb = y - yh;
        return xb * yb - (x * y - xh * yh - xb * yh - xh * yb);
    }

    DeuxDoubles plus(DeuxDoubles y) {
        double s = haut + y.haut;
        return somme(s, reste(haut, y.haut, s) + (bas + y.bas));
    }

    DeuxDoubles moins(DeuxDoubles y) {
        return plus(new DeuxDoubles(-y.haut, -y.bas));
    }

    DeuxDoubles fois(double y) {
        return somme(haut * y, perte(haut, y) + bas * y);
    }

    DeuxDoubles fois(DeuxDoubles y) {
        return somme(haut * y.haut, perte(haut, y.haut) + (haut * y.bas + bas * y.haut));
    }
}
