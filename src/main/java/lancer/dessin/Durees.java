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

    private final long[] toutes;
    /** La seconde moitié, de la plus courte à la plus longue. */
    private final long[] gardees;
    /** Le rang du bas de l'intervalle dans {@link #gardees}. */
    private final int rang;

    /** @param toutes en nanosecondes */
    public Durees(long... toutes) {
        this.toutes = toutes;
        gardees = Arrays.stream(toutes).skip(toutes.length / 2).sorted().toArray();
        rang = (int) Math.max(0, (gardees.length - NORMALE * Math.sqrt(gardees.length)) / 2);
    }

    public Durees avec(long duree) {
        return new Durees(LongStream.concat(Arrays.stream(toutes), LongStream.of(duree)).toArray());
    }

    public int getNombre() {
        return toutes.length;
    }

    public long getSomme() {
        return Arrays.stream(toutes).sum();
    }

    /** La médiane des durées qui comptent, en nanosecondes. */
    public double getMediane() {
        return (gardees[(gardees.length - 1) / 2] + gardees[gardees.length / 2]) / 2.0;
    }

    /** La plus petite durée de l'intervalle de la médiane, à 95 % si cinq durées ou plus comptent. */
    public long getMin() {
        return gardees[rang];
    }

    public long getMax() {
        return gardees[gardees.length - 1 - rang];
    }
}
