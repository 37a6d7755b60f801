package lancer.rapide;

import lancer.Constantes;
import lancer.fils.Equipe;
import lancer.precision.Intersection;

/**
 * Un arbre de boîtes, parcouru de la plus proche à la plus lointaine : rarement le meilleur ici, mais ni les tailles,
 * ni les places, ni les distances ne le mettent en défaut. Il sert là où une grille ou une carte coûterait davantage,
 * et pour les rayons qui ne sont pas de ceux d'une carte. {@link ConstructionArbre} ne le fait qu'à la première
 * question : d'ordinaire, personne n'en pose.
 *
 * <p>Une boîte n'est passée que si aucune de ses sphères ne peut l'emporter, arrondis compris. La distance calculée par
 * {@link Intersection#distance} est celle d'une sphère dont le rayon diffère d'au plus 16 u (|C − P| + r), u = 2^-53, et les
 * plans d'une boîte se traversent à 4 u (|P| + |boîte|) près : chaque boîte est élargie de {@link Noeuds#MARGE} fois sa
 * plus grande coordonnée, et chaque rayon s'élargit d'autant de fois celle de son départ. La marge suit donc ce que le
 * rayon et la boîte ont de grand, et rien d'autre dans la scène.
 */
final class Arbre implements Intersections, Occultations {

    /** Au-dessous, une composante de V vaut cela : son inverse reste fini. */
    private static final double PLUS_PETITE = 1e-300;

    private final Spheres spheres;
    private final Equipe equipe;
    private volatile Noeuds noeuds;

    /** @param equipe celle dont l'arrêt arrête aussi la construction */
    Arbre(Spheres spheres, Equipe equipe) {
        this.spheres = spheres;
        this.equipe = equipe;
    }

    /** Les nœuds, construits s'ils ne le sont pas encore. */
    Noeuds noeuds() {
        Noeuds faits = noeuds;
        if (faits == null) {
            synchronized (this) {
                faits = noeuds;
                if (faits == null) {
                    faits = new ConstructionArbre(spheres, equipe).construire();
                    noeuds = faits;
                }
            }
        }
        return faits;
    }

    @Override
    public int plusProche(Parcours parcours, double px, double py, double pz, double vx, double vy, double vz,
            int sauf) {
        parcours.distance = Constantes.INFINI;
        return chercher(parcours, px, py, pz, vx, vy, vz, sauf, false);
    }

    @Override
    public boolean cachee(Parcours parcours, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        parcours.distance = distance;
        return chercher(parcours, px, py, pz, vx, vy, vz, sauf, true) >= 0;
    }

    /** @param premiereVenue vrai pour s'arrêter à la première sphère à moins de {@code parcours.distance} */
    private int chercher(Parcours parcours, double px, double py, double pz, double vx, double vy, double vz,
            int sauf, boolean premiereVenue) {
        Noeuds arbre = noeuds();
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
        // d'où le rayon entre au plus tôt, et sort au plus tard
        double marge = Noeuds.MARGE * Math.max(Math.abs(px), Math.max(Math.abs(py), Math.abs(pz)));
        double pex = ix < 0 ? px - marge : px + marge;
        double pey = iy < 0 ? py - marge : py + marge;
        double pez = iz < 0 ? pz - marge : pz + marge;
        double psx = 2 * px - pex;
        double psy = 2 * py - pey;
        double psz = 2 * pz - pez;
        double[] q = arbre.boites;
        double[] g = spheres.geometrie;
        int[] pile = parcours.pile;
        double[] entrees = parcours.entrees;
        double distance = parcours.distance;
        int trouvee = -1;
        int tests = 0;
        int visites = 0;
        int haut = 0;
        int n = 0;
        boolean fini = spheres.nombre == 0;
        while (!fini) {
            int c = arbre.compte[n];
            int s = arbre.suite[n];
            if (c > 0) {
                for (int f = s; f < s + c; f++) {
                    int k = arbre.feuilles[f];
                    if (k == sauf) {
                        continue;
                    }
                    tests++;
                    int i = Spheres.PAS * k;
                    double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[i], g[i + 1], g[i + 2], g[i + 3]);
                    if (d < 0) {
                        d = parcours.trancher(spheres, k, px, py, pz, vx, vy, vz);
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
                visites += 2;
                int b = Noeuds.PAS * s;
                double e0 = Math.max(Math.max((q[b + ex] - pex) * ix, (q[b + ey] - pey) * iy),
                        Math.max((q[b + ez] - pez) * iz, 0));
                double s0 = Math.min(Math.min((q[b + sx] - psx) * ix, (q[b + sy] - psy) * iy),
                        Math.min((q[b + sz] - psz) * iz, distance));
                b += Noeuds.PAS;
                double e1 = Math.max(Math.max((q[b + ex] - pex) * ix, (q[b + ey] - pey) * iy),
                        Math.max((q[b + ez] - pez) * iz, 0));
                double s1 = Math.min(Math.min((q[b + sx] - psx) * ix, (q[b + sy] - psy) * iy),
                        Math.min((q[b + sz] - psz) * iz, distance));
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
            fini = haut < 0;
            n = fini ? 0 : pile[haut];
        }
        parcours.compteurs.testsSpheres += tests;
        parcours.compteurs.noeudsVisites += visites;
        parcours.distance = distance;
        return trouvee;
    }

    static double inverse(double v) {
        return 1 / (Math.abs(v) < PLUS_PETITE ? PLUS_PETITE : v);
    }
}
