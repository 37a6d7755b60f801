package lancer.rapide;

/**
 * Un ordre où des sphères voisines dans l'espace le sont en mémoire : les bits de x, y et z entrelacés (Morton, 1966).
 */
final class Morton {

    private static final int BITS = 10;

    private Morton() {
    }

    /** Les numéros des sphères, dans cet ordre. */
    static int[] ordre(Spheres spheres, Boite boite) {
        double[] g = spheres.geometrie;
        long[] cles = new long[spheres.nombre];
        double cote = Math.max(boite.xMax - boite.xMin, Math.max(boite.yMax - boite.yMin, boite.zMax - boite.zMin));
        double echelle = (1 << BITS) / cote;
        for (int c = 0; c < cles.length; c++) {
            int s = Spheres.PAS * c;
            long code = etale((g[s] - boite.xMin) * echelle) | etale((g[s + 1] - boite.yMin) * echelle) << 1
                    | etale((g[s + 2] - boite.zMin) * echelle) << 2;
            cles[c] = code << 32 | c;
        }
        int[] ordre = new int[cles.length];
        int k = 0;
        for (long cle : Tri.parMoitieHaute(cles)) {
            ordre[k++] = (int) cle;
        }
        return ordre;
    }

    /** Les bits d'un entier, écartés de deux zéros. */
    private static long etale(double x) {
        int n = Math.max(0, Math.min((1 << BITS) - 1, (int) x));
        n = (n | n << 16) & 0x030000FF;
        n = (n | n << 8) & 0x0300F00F;
        n = (n | n << 4) & 0x030C30C3;
        n = (n | n << 2) & 0x09249249;
        return n;
    }
}
