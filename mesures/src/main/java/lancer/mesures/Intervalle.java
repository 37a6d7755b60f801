package lancer.mesures;

import java.util.Arrays;

/** Une valeur mesurée et son intervalle de confiance à 95 %. Immuable. */
public final class Intervalle {

    /** Quantiles à 97,5 % de la loi de Student, pour 1, 2, 3, puis 4 degrés de liberté. */
    private static final double[] STUDENT = {12.706, 4.303, 3.182, 2.776};

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
     * Pour moins de six rapports, intervalle de leur moyenne géométrique, par la loi de Student.
     */
    public static Intervalle desRapports(double... rapports) {
        double[] tries = Arrays.stream(rapports).sorted().toArray();
        int n = tries.length;
        if (n - 1 <= STUDENT.length) {
            return deLaMoyenne(Arrays.stream(rapports).map(Math::log).toArray());
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

    /** Intervalle de la moyenne géométrique ; infini pour une seule valeur. */
    private static Intervalle deLaMoyenne(double... logarithmes) {
        double moyenne = Arrays.stream(logarithmes).average().orElse(Double.NaN);
        int libertes = logarithmes.length - 1;
        double carres = Arrays.stream(logarithmes).map(x -> (x - moyenne) * (x - moyenne)).sum();
        double demi = libertes < 1 ? Double.POSITIVE_INFINITY
                : STUDENT[libertes - 1] * Math.sqrt(carres / libertes / logarithmes.length);
        return new Intervalle(Math.exp(moyenne), Math.exp(moyenne - demi), Math.exp(moyenne + demi));
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

    public Intervalle fois(double facteur) {
        return new Intervalle(valeur * facteur, min * facteur, max * facteur);
    }

    /** Dit si cet intervalle est tout entier sous l'autre. Les titres et les phrases n'affirment une différence que dans ce cas. */
    public boolean nettementSous(Intervalle autre) {
        return max < autre.min;
    }
}
