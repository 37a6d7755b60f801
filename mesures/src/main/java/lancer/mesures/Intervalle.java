package lancer.mesures;

import java.util.Arrays;

/** Un nombre mesuré, et entre quoi il est, 19 fois sur 20. Immuable. */
public final class Intervalle {

    /** Le quantile à 97,5 % de la loi de Student, de 1 à 9 degrés de liberté, puis celui de la loi normale, un peu plus petit. */
    private static final double[] STUDENT = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262};
    private static final double NORMALE = 1.96;

    public final double valeur;
    public final double min;
    public final double max;

    public Intervalle(double valeur, double min, double max) {
        this.valeur = valeur;
        this.min = min;
        this.max = max;
    }

    /** La moyenne de ces nombres, par la loi de Student. D'un seul, on ne sait rien d'autre que lui. */
    private static Intervalle deLaMoyenne(double... nombres) {
        double moyenne = Arrays.stream(nombres).average().orElse(Double.NaN);
        int libertes = nombres.length - 1;
        double carres = Arrays.stream(nombres).map(x -> (x - moyenne) * (x - moyenne)).sum();
        double demi = libertes < 1 ? Double.POSITIVE_INFINITY
                : STUDENT[Math.min(libertes, STUDENT.length) - 1] * Math.sqrt(carres / libertes / nombres.length);
        return new Intervalle(moyenne, moyenne - demi, moyenne + demi);
    }

    /** La moyenne géométrique de ces rapports : celle de leurs logarithmes. */
    public static Intervalle desRapports(double... rapports) {
        Intervalle log = deLaMoyenne(Arrays.stream(rapports).map(Math::log).toArray());
        return new Intervalle(Math.exp(log.valeur), Math.exp(log.min), Math.exp(log.max));
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

    /** Multiplié, et divisé, par ce facteur au plus. */
    public Intervalle elargi(double facteur) {
        return new Intervalle(valeur, min / facteur, max * facteur);
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
