package lancer.mesures;

import java.util.Arrays;

/** Une valeur mesurée et son intervalle de confiance à 95 %. Immuable. */
public final class Intervalle {

    /** Nombre de rapports au-dessous duquel deux d'entre eux n'encadrent pas assez souvent la médiane. */
    private static final int ASSEZ = 6;

    /** Quantile de la loi normale. */
    private static final double NORMALE = 1.96;

    /** Probabilité laissée au-delà de chaque borne. */
    private static final double DEHORS = 0.025;

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

    /**
     * Intervalle de la médiane de ces rapports, entre deux rangs que donne la loi binomiale : une valeur aberrante ne compte que pour une.
     * Il est infini pour moins de six rapports.
     */
    public static Intervalle desRapports(double... rapports) {
        double[] tries = Arrays.stream(rapports).sorted().toArray();
        int n = tries.length;
        if (n < ASSEZ) {
            return new Intervalle(mediane(tries), 0, Double.POSITIVE_INFINITY);
        }
        // nombre de rapports à laisser de chaque côté, pour que la médiane soit rarement au-delà
        int laisses = 0;
        double tant = n * Math.pow(0.5, n);
        for (double moins = Math.pow(0.5, n); moins + tant <= DEHORS; tant *= (n - laisses) / (laisses + 1.0)) {
            moins += tant;
            laisses++;
        }
        return new Intervalle(mediane(tries), tries[laisses], tries[n - 1 - laisses]);
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

    public Intervalle fois(double facteur) {
        return new Intervalle(valeur * facteur, min * facteur, max * facteur);
    }

    /** Dit si cet intervalle est tout entier sous l'autre. Les titres et les phrases n'affirment une différence que dans ce cas. */
    public boolean nettementSous(Intervalle autre) {
        return max < autre.min;
    }
}
