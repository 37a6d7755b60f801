package lancer.rapide;

import java.util.Arrays;

/** Les sphères trop grandes ou trop éloignées pour une grille : un sol, un ciel, une étoile. */
final class Demesurees {

    /**
     * Une sphère est démesurée si son rayon dépasse {@code GROSSE} fois le rayon médian, ou sa distance au milieu
     * {@code ECARTEE} fois la distance médiane. Les médianes sont celles d'un échantillon.
     */
    private static final double GROSSE = 50;
    private static final double ECARTEE = 64;
    private static final int ECHANTILLON = 1000;

    private final double[] g;
    private final double[] milieu = new double[Spheres.PAS];
    private final double loin;

    Demesurees(Spheres spheres) {
        g = spheres.geometrie;
        int pas = 1 + spheres.nombre / ECHANTILLON;
        double[] valeurs = new double[(spheres.nombre + pas - 1) / pas];
        for (int axe = 0; axe < Spheres.PAS; axe++) {
            for (int i = 0; i < valeurs.length; i++) {
                valeurs[i] = g[Spheres.PAS * pas * i + axe];
            }
            milieu[axe] = mediane(valeurs);
        }
        for (int i = 0; i < valeurs.length; i++) {
            valeurs[i] = ecart(Spheres.PAS * pas * i);
        }
        loin = ECARTEE * mediane(valeurs);
    }

    boolean contient(int k) {
        int s = Spheres.PAS * k;
        return g[s + 3] > GROSSE * milieu[3] || ecart(s) > loin;
    }

    private static double mediane(double[] valeurs) {
        Arrays.sort(valeurs);
        return valeurs[valeurs.length / 2];
    }

    private double ecart(int s) {
        return Math.max(Math.abs(g[s] - milieu[0]),
                Math.max(Math.abs(g[s + 1] - milieu[1]), Math.abs(g[s + 2] - milieu[2])));
    }
}
