package lancer.rapide;

import java.util.Arrays;

/** Les quelques sphères démesurées (un sol, un ciel) qui rempliraient à elles seules une grille : à part, toujours examinées. */
final class Grosses {

    private Grosses() {
    }

    /** Les numéros, croissants, des sphères qui ne le sont pas. */
    static int[] lesAutres(Spheres spheres, int grossesMax) {
        int n = spheres.nombre;
        double[] g = spheres.geometrie;
        double seuil = Double.POSITIVE_INFINITY;
        if (grossesMax > 0 && n > 0) {
            double[] rayons = new double[n];
            for (int k = 0; k < n; k++) {
                rayons[k] = g[Spheres.PAS * k + 3];
            }
            Arrays.sort(rayons);
            seuil = Math.max(Preparation.GROSSE * rayons[n / 2], n > grossesMax ? rayons[n - 1 - grossesMax] : 0);
        }
        int[] autres = new int[n];
        int m = 0;
        for (int k = 0; k < n; k++) {
            if (g[Spheres.PAS * k + 3] <= seuil) {
                autres[m++] = k;
            }
        }
        return Arrays.copyOf(autres, m);
    }

    /** Les numéros de 0 à n − 1 qui ne sont pas dans cette liste croissante. */
    static int[] complement(int[] liste, int n) {
        int[] reste = new int[n - liste.length];
        int i = 0;
        int m = 0;
        for (int k = 0; k < n; k++) {
            if (i < liste.length && liste[i] == k) {
                i++;
            } else {
                reste[m++] = k;
            }
        }
        return reste;
    }
}
