package lancer.auto;

/**
 * Des points répartis dans le carré unité, en réseau de Fibonacci (Sloan et Joe, « Lattice Methods for Multiple
 * Integration », 1994) : l'erreur d'une moyenne sur un pixel coupé par un bord y décroît à peu près comme leur nombre à
 * la puissance −3/4. Immuable.
 */
final class Reseau {

    /** Points de chacune de deux références, pour que l'erreur de leur produit ne gêne pas à un niveau près. */
    private static final double POUR_UN_NIVEAU = 55;

    private static final int POINTS_MIN = 13;
    private static final int POINTS_MAX = 233;

    final int points;
    private final int generateur;

    /** @param auMoins le nombre de points est le nombre de Fibonacci qui suit */
    Reseau(int auMoins) {
        int a = 1;
        int b = 2;
        while (b < auMoins) {
            int suivant = a + b;
            a = b;
            b = suivant;
        }
        generateur = a;
        points = b;
    }

    /** De quoi mesurer une erreur de cet ordre, en niveaux. */
    static Reseau pour(double erreur) {
        double points = POUR_UN_NIVEAU * Math.pow(erreur, -4.0 / 3);
        return new Reseau((int) Math.max(POINTS_MIN, Math.min(POINTS_MAX, points)));
    }

    /**
     * L'abscisse du point k, de 0 compris à 1 exclu.
     *
     * @param decalage de tout le réseau, de 0 à 1 ; ce qui sort d'un côté rentre de l'autre
     */
    double x(int k, double decalage) {
        return partie((k + 0.5) / points + decalage);
    }

    /** Son ordonnée. */
    double y(int k, double decalage) {
        return partie((k * generateur % points + 0.5) / points + decalage);
    }

    private static double partie(double x) {
        return x < 1 ? x : x - 1;
    }
}
