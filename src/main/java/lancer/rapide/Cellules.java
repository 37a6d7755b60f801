package lancer.rapide;

import lancer.contrat.Recherche;

/**
 * Des boules rangées dans une grille de cubes : chaque cube donne celles qui le touchent. Les boules sont les
 * enveloppes elles-mêmes ou, vues d'un point, leurs cônes : un cône de directions coupe la sphère unité comme une boule
 * dont le rayon est la corde de son demi-angle.
 */
final class Cellules {

    /** Nombre maximal de cubes par côté, et de cubes par cube demandé. */
    private static final int COTES_MAX = 1024;
    private static final double CUBES_MAX = 16;

    /** Élargissement de chaque boule : les erreurs d'un rayon dans la grille sont plus petites. */
    private final double marge;
    private final boolean directions;

    /** Le coin de la grille, le côté d'un cube et son inverse, le nombre de cubes de chaque côté. */
    final double x0;
    final double y0;
    final double z0;
    final double cote;
    final double parCote;
    final int nx;
    final int ny;
    final int nz;

    /** Première place de chaque cube dans {@link #objets} ; celle du suivant est sa fin. */
    final int[] debut;
    int[] objets;

    private Cellules(double[] boules, int[] ordre, double marge, boolean directions, int cubes) {
        this.marge = marge;
        this.directions = directions;
        double[] bas = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] haut = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int k : ordre) {
            int s = Enveloppes.PAS * k;
            double r = boules[s + 3] + marge;
            for (int a = 0; a < 3; a++) {
                bas[a] = Math.min(bas[a], boules[s + a] - r);
                haut[a] = Math.max(haut[a], boules[s + a] + r);
            }
        }
        for (int a = 0; a < 3 && directions; a++) {
            bas[a] = Math.max(bas[a], -1 - marge);
            haut[a] = Math.min(haut[a], 1 + marge);
        }
        x0 = bas[0];
        y0 = bas[1];
        z0 = bas[2];
        double x = haut[0] - x0;
        double y = haut[1] - y0;
        double z = haut[2] - z0;
        double c = directions ? Math.sqrt((x * y + y * z + z * x) / cubes)
                : Math.cbrt(x) * Math.cbrt(y) * Math.cbrt(z) / Math.cbrt(cubes);
        c = Math.max(c, Math.max(marge, Enveloppes.plusGrande(x, y, z) / COTES_MAX));
        while ((1 + x / c) * (1 + y / c) * (1 + z / c) > CUBES_MAX * cubes + 8) {
            c *= 1.125;
        }
        cote = c;
        parCote = 1 / c;
        nx = 1 + (int) (x / c);
        ny = 1 + (int) (y / c);
        nz = 1 + (int) (z / c);
        debut = new int[nx * ny * nz + 1];
    }

    /**
     * Range ces boules.
     *
     * @param boules leurs centres et rayons, notés comme {@link Enveloppes#geometrie}
     * @param ordre leurs rangs, un au moins, dans l'ordre où chaque cube les donne
     * @param directions vrai si elles sont vues d'un point : seuls servent les cubes qui touchent la sphère unité
     * @param cubes nombre de cubes voulu, à peu près
     * @param placesMax nombre maximal de rangs, de tous les cubes ensemble
     * @return {@code null} s'il en faut plus
     */
    static Cellules de(double[] boules, int[] ordre, double marge, boolean directions, int cubes,
            int placesMax) {
        Cellules cellules = new Cellules(boules, ordre, marge, directions, cubes);
        long places = 0;
        for (int k : ordre) {
            Recherche.obeir();
            places += cellules.noter(boules, k, false);
            if (places > placesMax) {
                return null;
            }
        }
        for (int c = 1; c < cellules.debut.length; c++) {
            cellules.debut[c] += cellules.debut[c - 1];
        }
        cellules.objets = new int[(int) places];
        for (int o = ordre.length - 1; o >= 0; o--) {
            cellules.noter(boules, ordre[o], true);
        }
        return cellules;
    }

    /**
     * Compte la boule k dans chaque cube qu'elle touche ou, une fois tous comptés, l'y range.
     *
     * @return le nombre de ces cubes
     */
    private int noter(double[] boules, int k, boolean ranger) {
        int s = Enveloppes.PAS * k;
        double r = boules[s + 3] + marge;
        int touches = 0;
        int i1 = rang(boules[s] + r - x0, nx);
        int j1 = rang(boules[s + 1] + r - y0, ny);
        int k1 = rang(boules[s + 2] + r - z0, nz);
        for (int i = rang(boules[s] - r - x0, nx); i <= i1; i++) {
            double bx = x0 + i * cote;
            double x2 = carreDeLEcart(boules[s], bx);
            for (int j = rang(boules[s + 1] - r - y0, ny); j <= j1; j++) {
                double by = y0 + j * cote;
                double xy2 = x2 + carreDeLEcart(boules[s + 1], by);
                for (int l = rang(boules[s + 2] - r - z0, nz); l <= k1 && xy2 <= r * r; l++) {
                    double bz = z0 + l * cote;
                    if (xy2 + carreDeLEcart(boules[s + 2], bz) <= r * r && sert(bx, by, bz)) {
                        int c = (i * ny + j) * nz + l;
                        touches++;
                        if (ranger) {
                            objets[--debut[c]] = k;
                        } else {
                            debut[c]++;
                        }
                    }
                }
            }
        }
        return touches;
    }

    private int rang(double x, int n) {
        return Math.max(0, Math.min((int) (x * parCote), n - 1));
    }

    /** Le carré de la distance de x à l'intervalle d'un cube. */
    private double carreDeLEcart(double x, double bas) {
        double ecart = Math.max(0, Math.max(bas - x, x - bas - cote));
        return ecart * ecart;
    }

    /** Dit si ce cube, donné par son coin, touche la sphère unité, ou s'il n'est pas de directions. */
    private boolean sert(double x, double y, double z) {
        return !directions || carreDeLEcart(0, x) + carreDeLEcart(0, y) + carreDeLEcart(0, z) <= 1 + marge
                && carreDuLoin(x) + carreDuLoin(y) + carreDuLoin(z) >= 1 - marge;
    }

    private double carreDuLoin(double bas) {
        double loin = Math.max(-bas, bas + cote);
        return loin * loin;
    }

    /** Le cube de ce point, −1 s'il est hors de la grille. */
    int cubeDe(double x, double y, double z) {
        int i = (int) ((x - x0) * parCote);
        int j = (int) ((y - y0) * parCote);
        int l = (int) ((z - z0) * parCote);
        return i >= 0 && i < nx && j >= 0 && j < ny && l >= 0 && l < nz ? (i * ny + j) * nz + l : -1;
    }
}
