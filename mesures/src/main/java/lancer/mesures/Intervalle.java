package lancer.mesures;

import java.util.Arrays;

/** Une valeur mesurée et son intervalle de confiance à 95 %. Immuable. */
public final class Intervalle {

    /** Quantile de la loi normale. */
    private static final double NORMALE = 1.96;

    public final double valeur;
    public final double min;
    public final double max;

    public Intervalle(double valeur, double min, double max) {
        this.valeur = valeur;
        this.min = min;
        this.max = max;
    }

    /** Une valeur connue exactement. */
    public static Intervalle exact(double valeur) {
        return new Intervalle(valeur, valeur, valeur);
    }

    /** Intervalle de la racine de la moyenne de ces carrés, indépendants. */
    public static Intervalle deLaRacine(double... carres) {
        double moyenne = Arrays.stream(carres).average().orElse(Double.NaN);
        double ecarts = Arrays.stream(carres).map(c -> (c - moyenne) * (c - moyenne)).sum();
        double demi = NORMALE * Math.sqrt(ecarts / carres.length / Math.max(1, carres.length - 1));
        return new Intervalle(racine(moyenne), racine(moyenne - demi), racine(moyenne + demi));
    }

    private static double racine(double carre) {
        return Math.sqrt(Math.max(0, carre));
    }

    /** La médiane ; NaN sans valeur. */
    public static double mediane(double... valeurs) {
        double[] tries = Arrays.stream(valeurs).sorted().toArray();
        return tries.length == 0 ? Double.NaN : Math.sqrt(tries[(tries.length - 1) / 2] * tries[tries.length / 2]);
    }

    /** Cet intervalle, ou sa valeur seule si une borne n'est pas connue ou ne se place pas sur un axe logarithmique. */
    public Intervalle montrable() {
        return min > 0 && max < Double.POSITIVE_INFINITY ? this : exact(valeur);
    }
}
