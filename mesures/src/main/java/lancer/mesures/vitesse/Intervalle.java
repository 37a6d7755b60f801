package lancer.mesures.vitesse;

import java.util.Arrays;

/** Un nombre mesuré, et entre quoi il est, 19 fois sur 20. Immuable. */
final class Intervalle {

    /** Le quantile à 97,5 % de la loi de Student, de 1 à 9 degrés de liberté, puis celui de la loi normale, un peu plus petit. */
    private static final double[] STUDENT = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262};
    private static final double NORMALE = 1.96;

    final double valeur;
    final double min;
    final double max;

    Intervalle(double valeur, double min, double max) {
        this.valeur = valeur;
        this.min = min;
        this.max = max;
    }

    /** La moyenne géométrique de ces rapports : Student sur leurs logarithmes. D'un seul, on ne sait rien d'autre que lui. */
    static Intervalle desRapports(double... rapports) {
        double[] logs = Arrays.stream(rapports).map(Math::log).toArray();
        double moyenne = Arrays.stream(logs).average().orElse(Double.NaN);
        int libertes = logs.length - 1;
        if (libertes < 1) {
            return new Intervalle(Math.exp(moyenne), 0, Double.POSITIVE_INFINITY);
        }
        double carres = Arrays.stream(logs).map(l -> (l - moyenne) * (l - moyenne)).sum();
        double quantile = libertes <= STUDENT.length ? STUDENT[libertes - 1] : STUDENT[STUDENT.length - 1];
        double demi = quantile * Math.sqrt(carres / libertes / logs.length);
        return new Intervalle(Math.exp(moyenne), Math.exp(moyenne - demi), Math.exp(moyenne + demi));
    }

    /** La racine de la moyenne de ces carrés, tirés chacun à part. */
    static Intervalle deLaRacine(double... carres) {
        double moyenne = Arrays.stream(carres).average().orElse(Double.NaN);
        double ecarts = Arrays.stream(carres).map(c -> (c - moyenne) * (c - moyenne)).sum();
        double demi = NORMALE * Math.sqrt(ecarts / carres.length / Math.max(1, carres.length - 1));
        return new Intervalle(racine(moyenne), racine(moyenne - demi), racine(moyenne + demi));
    }

    private static double racine(double carre) {
        return Math.sqrt(Math.max(0, carre));
    }

    /** Multiplié, et divisé, par ce facteur au plus. */
    Intervalle elargi(double facteur) {
        return new Intervalle(valeur, min / facteur, max * facteur);
    }

    Intervalle fois(double facteur) {
        return new Intervalle(valeur * facteur, min * facteur, max * facteur);
    }

    /**
     * La seule question qui permette de dire une différence : celui-ci est-il plus petit, à coup sûr ? Titres et phrases n'en
     * disent aucune autre.
     */
    boolean nettementSous(Intervalle autre) {
        return max < autre.min;
    }
}
