package lancer.dessin;

import java.util.Arrays;
import java.util.stream.LongStream;

/**
 * Les durées des dessins d'une même image, dans leur ordre. La première moitié s'exécute avant la fin de la
 * compilation, et ne compte pas. Immuable.
 */
public final class Durees {

    /** Quantile à 97,5 % de la loi normale. */
    private static final double NORMALE = 1.96;

    private final long[] durees;
    /** La seconde moitié, de la plus courte à la plus longue. */
    private final long[] secondeMoitie;
    /** Le rang du bas de l'intervalle dans {@link #secondeMoitie}. */
    private final int rang;

    /** @param durees en nanosecondes */
    public Durees(long... durees) {
        this.durees = durees;
        secondeMoitie = Arrays.stream(durees).skip(durees.length / 2).sorted().toArray();
        rang = (int) Math.max(0, (secondeMoitie.length - NORMALE * Math.sqrt(secondeMoitie.length)) / 2);
    }

    public Durees avec(long duree) {
        return new Durees(LongStream.concat(Arrays.stream(durees), LongStream.of(duree)).toArray());
    }

    public int getNombre() {
        return durees.length;
    }

    public long getSomme() {
        return Arrays.stream(durees).sum();
    }

    /** La médiane des durées qui comptent, en nanosecondes. */
    public double getMediane() {
        return (secondeMoitie[(secondeMoitie.length - 1) / 2] + secondeMoitie[secondeMoitie.length / 2]) / 2.0;
    }

    /** La plus petite durée de l'intervalle de la médiane, à 95 % si cinq durées ou plus comptent. */
    public long getMin() {
        return secondeMoitie[rang];
    }

    public long getMax() {
        return secondeMoitie[secondeMoitie.length - 1 - rang];
    }
}
