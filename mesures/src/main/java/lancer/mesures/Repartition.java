package lancer.mesures;

import java.util.Arrays;

/** Des temps rangés : leur milieu, et comment ils s'en écartent. */
public final class Repartition {

    private final long[] tries;

    /** @param temps au moins un, dans un ordre quelconque */
    public Repartition(long... temps) {
        if (temps.length == 0) {
            throw new IllegalArgumentException("aucun temps");
        }
        tries = temps.clone();
        Arrays.sort(tries);
    }

    public int nombre() {
        return tries.length;
    }

    public double mediane() {
        return quantile(0.5);
    }

    public double premierQuartile() {
        return quantile(0.25);
    }

    public double troisiemeQuartile() {
        return quantile(0.75);
    }

    public long min() {
        return tries[0];
    }

    public long max() {
        return tries[tries.length - 1];
    }

    /** Le temps de rang p·(n − 1), compté de 0 ; entre deux rangs, en proportion (Hyndman et Fan, 1996, définition 7). */
    private double quantile(double p) {
        double rang = p * (tries.length - 1);
        int dessous = (int) rang;
        int dessus = Math.min(dessous + 1, tries.length - 1);
        return tries[dessous] + (rang - dessous) * (tries[dessus] - tries[dessous]);
    }
}
