package lancer.essai;

import lancer.Couleur;
import lancer.Tuple;

/** Les opérations de l'énoncé sur des triplets de nombres, refaites sans les classes du cours. */
public final class Triplets {

    private Triplets() {
    }

    public static double[] t(Tuple p) {
        return new double[] {p.x, p.y, p.z};
    }

    public static double[] t(Couleur c) {
        return new double[] {c.r, c.v, c.b};
    }

    public static double[] gris(double g) {
        return new double[] {g, g, g};
    }

    public static void ajouter(double[] a, double[] b) {
        for (int c = 0; c < 3; c++) {
            a[c] += b[c];
        }
    }

    public static double[] plus(double[] a, double k, double[] b) {
        return new double[] {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
    }

    public static double[] moins(double[] a, double[] b) {
        return plus(a, -1, b);
    }

    public static double[] fois(double[] a, double[] b) {
        return new double[] {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
    }

    public static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    public static double[] unite(double[] a) {
        return fois(a, gris(1 / Math.sqrt(dot(a, a))));
    }
}
