package lancer.rapide;

import lancer.Constantes;
import lancer.Sphere;

/**
 * Un arbre de boîtes, parcouru de la plus proche à la plus lointaine : jamais le meilleur ici, mais ni les tailles ni
 * les places ne le mettent en défaut, tant que les coordonnées ne font pas des milliards de rayons (au-delà, {@link
 * Grosses}). Il sert là où une grille ou une carte coûterait davantage. Construit par {@link Pousse}.
 *
 * <p>Les boîtes sont des flottants arrondis vers l'extérieur et élargis d'une marge ({@link Etendue#marge}) : une boîte
 * n'est passée que si aucune de ses sphères ne peut l'emporter, arrondis compris.
 */
final class Arbre implements Voisins, Obstacles {

    /** Profondeur au plus : à partir de la moitié, la construction coupe en deux moitiés égales. */
    static final int PROFONDEUR_MAX = 64;

    /** Flottants par nœud : minimums, puis maximums. */
    static final int PAS = 6;

    /** Au-dessous, une composante de V vaut cela : son inverse reste fini. */
    static final double PLUS_PETITE = 1e-300;

    private final Spheres spheres;
    /** Les sphères qui ne sont pas dans l'arbre : toujours examinées. */
    private final int[] grosses;
    private final double departMax;
    /** Pour un rayon qui part de plus loin. */
    private final Boucle boucle;
    private final float[] boites;
    /** Premier des deux enfants, qui se suivent ; ou, d'une feuille, la première place dans {@link #feuilles}. */
    private final int[] suite;
    /** Nombre de sphères d'une feuille, 0 si ce n'en est pas une. */
    private final byte[] compte;
    private final int[] feuilles;

    Arbre(Spheres spheres, int[] grosses, double portee, float[] boites, int[] suite, byte[] compte, int[] feuilles) {
        this.spheres = spheres;
        this.grosses = grosses;
        departMax = Etendue.DEPART_MAX * portee;
        boucle = new Boucle(spheres);
        this.boites = boites;
        this.suite = suite;
        this.compte = compte;
        this.feuilles = feuilles;
    }

    @Override
    public int plusProche(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf) {
        if (loin(px, py, pz)) {
            return boucle.plusProche(sonde, px, py, pz, vx, vy, vz, sauf);
        }
        sonde.distance = Constantes.INFINI;
        return parcourir(sonde, px, py, pz, vx, vy, vz, sauf, false);
    }

    @Override
    public boolean cachee(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        if (loin(px, py, pz)) {
            return boucle.cachee(sonde, px, py, pz, vx, vy, vz, distance, sauf);
        }
        sonde.distance = distance;
        return parcourir(sonde, px, py, pz, vx, vy, vz, sauf, true) >= 0;
    }

    private boolean loin(double x, double y, double z) {
        return !(Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) <= departMax);
    }

    /** @param premiereVenue vrai pour s'arrêter à la première sphère à moins de {@code sonde.distance} */
    private int parcourir(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf,
            boolean premiereVenue) {
        double ix = inverse(vx);
        double iy = inverse(vy);
        double iz = inverse(vz);
        // les plans d'entrée : ceux du minimum si le rayon va vers les grands, ceux du maximum sinon
        int ex = ix < 0 ? 3 : 0;
        int ey = iy < 0 ? 4 : 1;
        int ez = iz < 0 ? 5 : 2;
        int sx = 3 - ex;
        int sy = 5 - ey;
        int sz = 7 - ez;
        float[] q = boites;
        double[] g = spheres.geometrie;
        int[] pile = sonde.pile;
        double[] entrees = sonde.entrees;
        double distance = sonde.distance;
        int trouvee = -1;
        int tests = 0;
        int noeuds = 0;
        int haut = 0;
        int n = 0;
        for (int k : grosses) {
            if (k != sauf) {
                tests++;
                int i = Spheres.PAS * k;
                double d = Sphere.distanceOuDoute(px, py, pz, vx, vy, vz, g[i], g[i + 1], g[i + 2], g[i + 3]);
                if (d < 0) {
                    d = sonde.trancher(spheres, k, px, py, pz, vx, vy, vz);
                }
                if (premiereVenue ? d < distance : d <= distance && spheres.avant(d, k, distance, trouvee)) {
                    distance = d;
                    trouvee = k;
                }
            }
        }
        boolean fini = suite.length == 0 || premiereVenue && trouvee >= 0;
        while (!fini) {
            int c = compte[n];
            int s = suite[n];
            if (c > 0) {
                for (int f = s; f < s + c; f++) {
                    int k = feuilles[f];
                    if (k == sauf) {
                        continue;
                    }
                    tests++;
                    int i = Spheres.PAS * k;
                    double d = Sphere.distanceOuDoute(px, py, pz, vx, vy, vz, g[i], g[i + 1], g[i + 2], g[i + 3]);
                    if (d < 0) {
                        d = sonde.trancher(spheres, k, px, py, pz, vx, vy, vz);
                    }
                    if (premiereVenue ? d < distance : d <= distance && spheres.avant(d, k, distance, trouvee)) {
                        distance = d;
                        trouvee = k;
                        if (premiereVenue) {
                            haut = 0;
                            break;
                        }
                    }
                }
            } else {
                noeuds += 2;
                int b = PAS * s;
                double e0 = Math.max(Math.max((q[b + ex] - px) * ix, (q[b + ey] - py) * iy),
                        Math.max((q[b + ez] - pz) * iz, 0));
                double s0 = Math.min(Math.min((q[b + sx] - px) * ix, (q[b + sy] - py) * iy),
                        Math.min((q[b + sz] - pz) * iz, distance));
                b += PAS;
                double e1 = Math.max(Math.max((q[b + ex] - px) * ix, (q[b + ey] - py) * iy),
                        Math.max((q[b + ez] - pz) * iz, 0));
                double s1 = Math.min(Math.min((q[b + sx] - px) * ix, (q[b + sy] - py) * iy),
                        Math.min((q[b + sz] - pz) * iz, distance));
                if (e0 <= s0) {
                    if (e1 <= s1) {
                        boolean premier = e0 <= e1;
                        pile[haut] = premier ? s + 1 : s;
                        entrees[haut++] = premier ? e1 : e0;
                        n = premier ? s : s + 1;
                    } else {
                        n = s;
                    }
                    continue;
                }
                if (e1 <= s1) {
                    n = s + 1;
                    continue;
                }
            }
            // à la même distance, une sphère qui vient avant dans la scène peut encore l'emporter
            do {
                haut--;
            } while (haut >= 0 && entrees[haut] > distance);
            if (haut < 0) {
                break;
            }
            n = pile[haut];
        }
        sonde.compteurs.testsSpheres += tests;
        sonde.compteurs.noeudsVisites += noeuds;
        sonde.distance = distance;
        return trouvee;
    }

    static double inverse(double v) {
        return 1 / (Math.abs(v) < PLUS_PETITE ? PLUS_PETITE : v);
    }
}
