package lancer.rapide;

import java.util.Arrays;

/**
 * La construction d'un {@link Arbre} : à chaque nœud, la coupe qui coûtera le moins selon l'aire des deux boîtes
 * (MacDonald et Booth, 1990), parmi {@value #TRANCHES} tranches par axe (Wald, 2007).
 */
final class Pousse {

    private static final int TRANCHES = 16;

    /** Feuilles larges : une sphère ne coûte pas plus à examiner qu'une boîte. */
    private static final int FEUILLE_MIN = 4;
    private static final int FEUILLE_MAX = 12;
    private static final double COUT_NOEUD = 3;

    private final double[] g;
    private final double marge;
    private final int[] ordre;
    private float[] boites;
    private int[] suite;
    private byte[] compte;
    private int noeuds;

    private Pousse(double[] geometrie, double marge, int[] ordre, int nombre) {
        this.g = geometrie;
        this.marge = marge;
        this.ordre = ordre;
        int places = Math.max(2, nombre / 2);
        boites = new float[Arbre.PAS * places];
        suite = new int[places];
        compte = new byte[places];
    }

    /**
     * L'arbre de ces sphères.
     *
     * @param lesquelles leurs numéros ; le tableau est gardé, et rangé par feuilles
     * @param grosses les sphères toujours examinées
     * @param portee plus grande coordonnée des sphères et du départ des rayons
     */
    static Arbre arbre(Spheres spheres, int[] lesquelles, int[] grosses, double portee) {
        int n = lesquelles.length;
        Pousse p = new Pousse(spheres.geometrie, Etendue.marge(portee), lesquelles, n);
        if (n > 0) {
            p.noeuds = 1;
            p.pousser(0, 0, n, 0);
        }
        return new Arbre(spheres, grosses, portee, Arrays.copyOf(p.boites, Arbre.PAS * p.noeuds),
                Arrays.copyOf(p.suite, p.noeuds), Arrays.copyOf(p.compte, p.noeuds), lesquelles);
    }

    private void pousser(int noeud, int debut, int fin, int profondeur) {
        Etendue centres = new Etendue();
        Etendue boite = new Etendue();
        for (int i = debut; i < fin; i++) {
            int s = Spheres.PAS * ordre[i];
            boite.ajouter(g[s], g[s + 1], g[s + 2], g[s + 3]);
            centres.ajouter(g[s], g[s + 1], g[s + 2], 0);
        }
        int b = Arbre.PAS * noeud;
        boites[b] = Etendue.enBas(boite.xMin - marge);
        boites[b + 1] = Etendue.enBas(boite.yMin - marge);
        boites[b + 2] = Etendue.enBas(boite.zMin - marge);
        boites[b + 3] = Etendue.enHaut(boite.xMax + marge);
        boites[b + 4] = Etendue.enHaut(boite.yMax + marge);
        boites[b + 5] = Etendue.enHaut(boite.zMax + marge);
        int n = fin - debut;
        int coupe = n <= FEUILLE_MIN ? -1 : profondeur > Arbre.PROFONDEUR_MAX / 2 ? moitie(debut, fin)
                : couper(debut, fin, centres, boite);
        if (coupe < 0) {
            suite[noeud] = debut;
            compte[noeud] = (byte) n;
            return;
        }
        int enfants = noeuds;
        noeuds += 2;
        if (noeuds > suite.length) {
            boites = Arrays.copyOf(boites, 2 * boites.length);
            suite = Arrays.copyOf(suite, 2 * suite.length);
            compte = Arrays.copyOf(compte, 2 * compte.length);
        }
        suite[noeud] = enfants;
        pousser(enfants, debut, coupe, profondeur + 1);
        pousser(enfants + 1, coupe, fin, profondeur + 1);
    }

    private static int moitie(int debut, int fin) {
        return fin - debut <= FEUILLE_MAX ? -1 : (debut + fin) >>> 1;
    }

    /**
     * Range les sphères de part et d'autre de la meilleure coupe, et rend son rang ; -1 s'il vaut mieux une feuille.
     */
    private int couper(int debut, int fin, Etendue centres, Etendue boite) {
        int n = fin - debut;
        double meilleur = Double.POSITIVE_INFINITY;
        int axe = -1;
        int tranche = 0;
        double[] bas = {centres.xMin, centres.yMin, centres.zMin};
        double[] pas = {(centres.xMax - centres.xMin) / TRANCHES, (centres.yMax - centres.yMin) / TRANCHES,
            (centres.zMax - centres.zMin) / TRANCHES};
        for (int a = 0; a < 3; a++) {
            if (!(pas[a] > 0)) {
                continue;
            }
            Etendue[] parts = new Etendue[TRANCHES];
            int[] nombres = new int[TRANCHES];
            for (int i = debut; i < fin; i++) {
                int s = Spheres.PAS * ordre[i];
                int t = tranche(g[s + a], bas[a], pas[a]);
                if (parts[t] == null) {
                    parts[t] = new Etendue();
                }
                parts[t].ajouter(g[s], g[s + 1], g[s + 2], g[s + 3]);
                nombres[t]++;
            }
            double[] aDroite = new double[TRANCHES];
            Etendue e = new Etendue();
            int c = 0;
            for (int t = TRANCHES - 1; t > 0; t--) {
                c += nombres[t];
                e.ajouter(parts[t]);
                aDroite[t] = c == 0 ? Double.POSITIVE_INFINITY : e.aire() * c;
            }
            e = new Etendue();
            c = 0;
            for (int t = 0; t < TRANCHES - 1; t++) {
                c += nombres[t];
                e.ajouter(parts[t]);
                double cout = c == 0 ? Double.POSITIVE_INFINITY : e.aire() * c + aDroite[t + 1];
                if (cout < meilleur) {
                    meilleur = cout;
                    axe = a;
                    tranche = t;
                }
            }
        }
        if (axe < 0) {
            return moitie(debut, fin);
        }
        if (n <= FEUILLE_MAX && COUT_NOEUD + meilleur / boite.aire() >= n) {
            return -1;
        }
        int i = debut;
        int j = fin;
        while (i < j) {
            if (tranche(g[Spheres.PAS * ordre[i] + axe], bas[axe], pas[axe]) <= tranche) {
                i++;
            } else {
                int k = ordre[i];
                ordre[i] = ordre[--j];
                ordre[j] = k;
            }
        }
        return i == debut || i == fin ? moitie(debut, fin) : i;
    }

    private static int tranche(double x, double bas, double pas) {
        return Math.min(TRANCHES - 1, (int) ((x - bas) / pas));
    }
}
