package lancer.rapide;

import java.util.concurrent.CancellationException;
import lancer.Constantes;
import lancer.contrat.Recherche;
import lancer.precision.Intersection;

/**
 * Hiérarchie de boîtes englobantes (BVH), parcourue de la boîte la plus proche à la plus lointaine. Elle convient à
 * toute scène, quelles que soient les tailles et les positions. Elle répond si une autre structure n'accepte pas le
 * rayon, ou si le crédit d'examens est épuisé. Les {@link Noeuds} sont construits à la première demande.
 *
 * <p>Une boîte n'est écartée que si aucune de ses sphères ne peut être le premier contact, arrondis compris.
 * {@link Intersection#distance} rend la distance exacte d'une sphère dont le rayon diffère d'au plus 16 u (|C − P| +
 * r), avec u = 2^-53. La traversée d'une boîte est calculée à 4 u (|P| + |boîte|) près. Chaque boîte est donc élargie
 * de {@link Noeuds#MARGE} fois sa plus grande coordonnée, et chaque rayon de {@link Noeuds#MARGE} fois celle de son
 * départ. Ainsi, cette marge ne dépend pas du reste de la scène.
 */
final class Arbre implements Intersections, Occultations {

    /** Une composante de V plus petite est remplacée par cette valeur : son inverse reste fini. */
    private static final double PLUS_PETITE = 1e-300;

    /** Réponse d'une descente suspendue après le nombre d'examens permis. */
    private static final int SUSPENDUE = -2;

    /** Nombre d'examens entre deux lectures de l'interruption du fil. */
    private static final int PAS = 1 << 14;

    /**
     * Un rayon d'ombre examine tour à tour {@code PAS_BOUCLES} sphères par les boucles, puis {@code PAS_ARBRE} nœuds
     * par l'arbre. Si k examens suffisent aux boucles, le total est au plus 3 k. Si k examens suffisent à l'arbre, le
     * total est au plus 1,5 k, plus un tour.
     */
    private static final int PAS_ARBRE = 16;
    private static final int PAS_BOUCLES = 8;

    private final Spheres spheres;
    private volatile Noeuds noeuds;
    /** Le temps de la construction, en nanosecondes ; 0 avant elle. */
    volatile long constructionNs;

    Arbre(Spheres spheres) {
        this.spheres = spheres;
    }

    /** Les nœuds, que construit le premier fil qui les demande. @throws CancellationException s'il est interrompu */
    Noeuds noeuds() {
        if (noeuds == null) {
            construire();
        }
        return noeuds;
    }

    private synchronized void construire() {
        if (noeuds == null) {
            long debut = System.nanoTime();
            noeuds = new Noeuds(spheres);
            constructionNs = System.nanoTime() - debut;
        }
    }

    @Override
    public int plusProche(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            int sauf) {
        long avant = etat.compteurs.examens();
        etat.distance = Constantes.INFINI;
        commencer(etat);
        int trouvee;
        do {
            Recherche.obeir();
            trouvee = descendre(etat, px, py, pz, vx, vy, vz, sauf, false, PAS);
        } while (trouvee == SUSPENDUE);
        etat.credit += etat.compteurs.examens() - avant;
        return trouvee;
    }

    @Override
    public boolean cachee(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        etat.credit += EtatDeRecherche.PAR_RAYON;
        return reprendre(etat, px, py, pz, vx, vy, vz, distance, sauf);
    }

    /**
     * Même réponse que {@link #cachee}, si une structure a déjà ajouté le crédit du rayon. La dernière sphère qui a
     * caché une lampe est examinée d'abord, puis l'arbre dans la limite du crédit. Ensuite, les boucles du cours et
     * l'arbre alternent : si la lampe est dans la première sphère de la scène, une descente entière est évitée.
     */
    boolean reprendre(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        long avant = etat.compteurs.examens();
        int b = etat.bloqueur;
        if (b >= 0 && b != sauf && etat.touche(spheres, b, px, py, pz, vx, vy, vz, distance)) {
            return true;
        }
        Recherche.obeir();
        etat.distance = distance;
        commencer(etat);
        int permis = (int) Math.max(0, Math.min(PAS, etat.credit));
        int trouvee = descendre(etat, px, py, pz, vx, vy, vz, sauf, true, permis);
        etat.credit -= etat.compteurs.examens() - avant;
        for (int r = 0; trouvee == SUSPENDUE;) {
            for (int fin = Math.min(r + PAS_BOUCLES, spheres.nombre); r < fin; r++) {
                if (r != sauf && etat.touche(spheres, r, px, py, pz, vx, vy, vz, distance)) {
                    etat.bloqueur = r;
                    return true;
                }
            }
            Recherche.obeir();
            trouvee = descendre(etat, px, py, pz, vx, vy, vz, sauf, true, PAS_ARBRE);
        }
        etat.bloqueur = trouvee >= 0 ? trouvee : b;
        return trouvee >= 0;
    }

    /** Met la racine dans la pile, s'il y a une sphère. */
    private void commencer(EtatDeRecherche etat) {
        etat.trouvee = -1;
        etat.pile[0] = 0;
        etat.entrees[0] = 0;
        etat.haut = spheres.nombre == 0 ? 0 : 1;
    }

    /**
     * Visite les nœuds de la pile.
     *
     * @param premiereVenue vrai pour s'arrêter à la première sphère à moins de {@code etat.distance}
     * @param permis nombre approché d'examens permis
     * @return la sphère trouvée, -1 s'il n'y en a pas, ou {@link #SUSPENDUE}
     */
    private int descendre(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            int sauf, boolean premiereVenue, int permis) {
        Noeuds arbre = noeuds();
        // les plans d'entrée sont les minimums si la composante de V est positive, les maximums sinon
        double ix = inverse(vx);
        double iy = inverse(vy);
        double iz = inverse(vz);
        int ex = ix < 0 ? 3 : 0;
        int ey = iy < 0 ? 4 : 1;
        int ez = iz < 0 ? 5 : 2;
        int sx = 3 - ex;
        int sy = 5 - ey;
        int sz = 7 - ez;
        // départs décalés de la marge : le rayon entre au plus tôt, et sort au plus tard
        double marge = Noeuds.MARGE * Math.max(Math.abs(px), Math.max(Math.abs(py), Math.abs(pz)));
        double pex = ix < 0 ? px - marge : px + marge;
        double pey = iy < 0 ? py - marge : py + marge;
        double pez = iz < 0 ? pz - marge : pz + marge;
        double psx = 2 * px - pex;
        double psy = 2 * py - pey;
        double psz = 2 * pz - pez;
        double[] q = arbre.boites;
        double[] g = spheres.geometrie;
        int[] pile = etat.pile;
        double[] entrees = etat.entrees;
        double distance = etat.distance;
        int trouvee = etat.trouvee;
        int haut = etat.haut;
        int tests = 0;
        int visites = 0;
        while (haut > 0 && tests + visites < permis) {
            // à distance égale, une sphère qui vient avant dans la scène l'emporte
            if (entrees[--haut] > distance) {
                continue;
            }
            int n = pile[haut];
            // descend par l'enfant le plus proche jusqu'à une feuille ; l'autre enfant va dans la pile
            while (n >= 0 && arbre.compte[n] == 0) {
                visites += 2;
                int s = arbre.suite[n];
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
                n = e0 <= s0 ? s : e1 <= s1 ? s + 1 : -1;
                if (e0 <= s0 && e1 <= s1) {
                    boolean premier = e0 <= e1;
                    pile[haut] = premier ? s + 1 : s;
                    entrees[haut++] = premier ? e1 : e0;
                    n = premier ? s : s + 1;
                }
            }
            for (int f = n < 0 ? 0 : arbre.suite[n], fin = n < 0 ? 0 : f + arbre.compte[n]; f < fin; f++) {
                int k = arbre.feuilles[f];
                if (k == sauf) {
                    continue;
                }
                tests++;
                int i = Spheres.PAS * k;
                double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[i], g[i + 1], g[i + 2], g[i + 3]);
                if (d < 0) {
                    d = etat.trancher(spheres, k, d, distance, px, py, pz, vx, vy, vz);
                }
                if (premiereVenue ? d < distance : d <= distance && Spheres.avant(d, k, distance, trouvee)) {
                    distance = d;
                    trouvee = k;
                    if (premiereVenue) {
                        haut = 0;
                        break;
                    }
                }
            }
        }
        etat.compteurs.testsSpheres += tests;
        etat.compteurs.noeudsVisites += visites;
        etat.distance = distance;
        etat.trouvee = trouvee;
        etat.haut = haut;
        return haut > 0 ? SUSPENDUE : trouvee;
    }

    static double inverse(double v) {
        return 1 / (Math.abs(v) < PLUS_PETITE ? PLUS_PETITE : v);
    }
}
