package lancer.mesures;

import java.util.Arrays;

/** Un nombre mesuré, et entre quoi il est, 19 fois sur 20. Immuable. */
public final class Intervalle {

    /** Le quantile à 97,5 % de la loi de Student, à partir d'un degré de liberté. */
    private static final double[] STUDENT = {12.706, 4.303, 3.182, 2.776};

    /** Quantile de la loi normale. */
    private static final double NORMALE = 1.96;

    /** Part qui peut être au-delà d'une borne, et de l'autre. */
    private static final double DEHORS = 0.025;

    public final double valeur;
    public final double min;
    public final double max;

    public Intervalle(double valeur, double min, double max) {
        this.valeur = valeur;
        this.min = min;
        this.max = max;
    }

    /** Un nombre que l'on connaît. */
    public static Intervalle exact(double valeur) {
        return new Intervalle(valeur, valeur, valeur);
    }

    /**
     * Valeur de ces rapports : leur médiane, entre les deux d'entre eux où la loi binomiale la met, si bien qu'un accident n'y compte
     * que pour un, si grand soit-il. De moins de six, les rangs ne diraient rien : leur moyenne géométrique, par la loi de Student.
     */
    public static Intervalle desRapports(double... rapports) {
        double[] tries = Arrays.stream(rapports).sorted().toArray();
        int n = tries.length;
        if (n - 1 <= STUDENT.length) {
            return deLaMoyenne(Arrays.stream(rapports).map(Math::log).toArray());
        }
        // combien en laisser de chaque côté : il est assez rare que la médiane ait si peu des rapports d'un côté
        int laisses = 0;
        double tant = n * Math.pow(0.5, n);
        for (double moins = Math.pow(0.5, n); moins + tant <= DEHORS; tant *= (n - laisses) / (laisses + 1.0)) {
            moins += tant;
            laisses++;
        }
        return new Intervalle(mediane(tries), tries[laisses], tries[n - 1 - laisses]);
    }

    /** Intervalle de la moyenne ; d'un seul, on ne sait rien d'autre que lui. */
    private static Intervalle deLaMoyenne(double... logarithmes) {
        double moyenne = Arrays.stream(logarithmes).average().orElse(Double.NaN);
        int libertes = logarithmes.length - 1;
        double carres = Arrays.stream(logarithmes).map(x -> (x - moyenne) * (x - moyenne)).sum();
        double demi = libertes < 1 ? Double.POSITIVE_INFINITY
                : STUDENT[libertes - 1] * Math.sqrt(carres / libertes / logarithmes.length);
        return new Intervalle(Math.exp(moyenne), Math.exp(moyenne - demi), Math.exp(moyenne + demi));
    }

    /** La racine de la moyenne de ces carrés, tirés chacun à part. */
    public static Intervalle deLaRacine(double... carres) {
        double moyenne = Arrays.stream(carres).average().orElse(Double.NaN);
        double ecarts = Arrays.stream(carres).map(c -> (c - moyenne) * (c - moyenne)).sum();
        double demi = NORMALE * Math.sqrt(ecarts / carres.length / Math.max(1, carres.length - 1));
        return new Intervalle(racine(moyenne), racine(moyenne - demi), racine(moyenne + demi));
    }

    private static double racine(double carre) {
        return Math.sqrt(Math.max(0, carre));
    }

    /** La médiane ; NaN de rien. */
    public static double mediane(double... valeurs) {
        double[] tries = Arrays.stream(valeurs).sorted().toArray();
        return tries.length == 0 ? Double.NaN : Math.sqrt(tries[(tries.length - 1) / 2] * tries[tries.length / 2]);
    }

    public Intervalle fois(double facteur) {
        return new Intervalle(valeur * facteur, min * facteur, max * facteur);
    }

    /**
     * La seule question qui permette de dire une différence : celui-ci est-il plus petit, à coup sûr ? Titres et phrases n'en
     * disent aucune autre.
     */
    public boolean nettementSous(Intervalle autre) {
        return max < autre.min;
    }
}
