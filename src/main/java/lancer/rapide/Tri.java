package lancer.rapide;

/** Tri par base (Hollerith, 1887), en trois passages. */
final class Tri {

    private static final int BITS = 11;

    private Tri() {
    }

    /** Trie ces clés par leur moitié haute, positive, sans changer l'ordre des clés égales. */
    static long[] parMoitieHaute(long[] cles) {
        long[] de = cles;
        long[] vers = new long[cles.length];
        for (int base = Integer.SIZE; base < Long.SIZE; base += BITS) {
            int[] places = new int[(1 << BITS) + 1];
            for (long cle : de) {
                places[1 + chiffre(cle, base)]++;
            }
            cumuler(places);
            for (long cle : de) {
                vers[places[chiffre(cle, base)]++] = cle;
            }
            long[] libre = de;
            de = vers;
            vers = libre;
        }
        return de;
    }

    /** Remplace chaque nombre par la somme des nombres jusqu'à lui. @return leur somme à tous */
    static int cumuler(int[] nombres) {
        for (int c = 1; c < nombres.length; c++) {
            nombres[c] += nombres[c - 1];
        }
        return nombres[nombres.length - 1];
    }

    private static int chiffre(long cle, int base) {
        return (int) (cle >>> base) & (1 << BITS) - 1;
    }
}
