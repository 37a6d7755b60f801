package lancer.rapide;

import java.util.Arrays;

/**
 * Les quelques sphères démesurées (un sol, un ciel, une boule perdue au loin) qui rempliraient à elles seules une
 * grille, ou dont les coordonnées élargiraient toutes les boîtes : à part, toujours examinées.
 */
final class Grosses {

    /**
     * Une sphère plus loin que cela, en rayons médians, a des coordonnées dont la marge ({@link Etendue#marge}) en vaut
     * un seizième.
     */
    private static final double LOINTAINE = 0x1p32;

    private Grosses() {
    }

    /** Les numéros, croissants, des sphères qui ne le sont pas. */
    static int[] lesAutres(Spheres spheres, int grossesMax) {
        int n = spheres.nombre;
        double[] demesures = new double[n];
        double seuil = Double.POSITIVE_INFINITY;
        if (grossesMax > 0 && n > 0) {
            double[] g = spheres.geometrie;
            double[] rayons = new double[n];
            for (int k = 0; k < n; k++) {
                rayons[k] = g[Spheres.PAS * k + 3];
            }
            Arrays.sort(rayons);
            double median = rayons[n / 2];
            double[] exces = rayons;
            int trop = 0;
            for (int k = 0; k < n; k++) {
                int s = Spheres.PAS * k;
                double portee = Math.max(Math.abs(g[s]), Math.max(Math.abs(g[s + 1]), Math.abs(g[s + 2])));
                demesures[k] = Math.max(g[s + 3] / (Preparation.GROSSE * median), portee / (LOINTAINE * median));
                if (demesures[k] > 1) {
                    exces[trop++] = demesures[k];
                }
            }
            Arrays.sort(exces, 0, trop);
            seuil = trop > grossesMax ? exces[trop - 1 - grossesMax] : 1;
        }
        int[] autres = new int[n];
        int m = 0;
        for (int k = 0; k < n; k++) {
            if (demesures[k] <= seuil) {
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
