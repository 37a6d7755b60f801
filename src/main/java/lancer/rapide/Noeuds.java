package lancer.rapide;

import java.util.Arrays;
import lancer.contrat.Recherche;

/**
 * Les nœuds d'un {@link Arbre} ; la racine est le nœud 0. Chaque division suit l'heuristique de l'aire (SAH, MacDonald
 * et Booth, 1990), parmi {@value #TRANCHES} tranches par axe (Wald, 2007).
 */
final class Noeuds {

    /** Élargissement d'une boîte et d'un rayon, en part de leurs coordonnées : 2,7 fois l'effet des arrondis. */
    static final double MARGE = 0x1.0p-46;

    /** Profondeur maximale. Les trente-deux derniers niveaux divisent en deux moitiés égales. */
    static final int PROFONDEUR_MAX = 96;

    /** Nombres par nœud dans {@link #boites} : trois minimums, puis trois maximums. */
    static final int PAS = 6;

    private static final int TRANCHES = 16;

    /** Taille des feuilles : examiner une sphère ne coûte pas plus qu'examiner une boîte. */
    private static final int FEUILLE_MIN = 4;
    private static final int FEUILLE_MAX = 12;
    private static final double COUT_NOEUD = 3;

    private final double[] g;
    double[] boites;
    /** Premier des deux enfants, qui se suivent ; pour une feuille, première place dans {@link #feuilles}. */
    int[] suite;
    /** Nombre de sphères d'une feuille, 0 pour un autre nœud. */
    byte[] compte;
    final int[] feuilles;
    private int nombre;

    /** @throws java.util.concurrent.CancellationException si ce fil est interrompu */
    Noeuds(Spheres spheres) {
        g = spheres.geometrie;
        feuilles = spheres.toutes();
        int places = Math.max(2, feuilles.length / 2);
        boites = new double[PAS * places];
        suite = new int[places];
        compte = new byte[places];
        if (feuilles.length > 0) {
            nombre = 1;
            diviser(0, 0, feuilles.length, 0);
        }
    }

    private void diviser(int noeud, int debut, int fin, int profondeur) {
        Recherche.obeir();
        Boite centres = new Boite();
        Boite boite = new Boite();
        for (int i = debut; i < fin; i++) {
            int s = Spheres.PAS * feuilles[i];
            boite.ajouter(g[s], g[s + 1], g[s + 2], g[s + 3]);
            centres.ajouter(g[s], g[s + 1], g[s + 2], 0);
        }
        int b = PAS * noeud;
        double marge = MARGE * boite.portee();
        boites[b] = boite.xMin - marge;
        boites[b + 1] = boite.yMin - marge;
        boites[b + 2] = boite.zMin - marge;
        boites[b + 3] = boite.xMax + marge;
        boites[b + 4] = boite.yMax + marge;
        boites[b + 5] = boite.zMax + marge;
        int n = fin - debut;
        int coupe = n <= FEUILLE_MIN ? -1 : profondeur > PROFONDEUR_MAX - Integer.SIZE ? moitie(debut, fin)
                : couper(debut, fin, centres, boite);
        if (coupe < 0) {
            suite[noeud] = debut;
            compte[noeud] = (byte) n;
            return;
        }
        int enfants = nombre;
        nombre += 2;
        if (nombre > suite.length) {
            boites = Arrays.copyOf(boites, 2 * boites.length);
            suite = Arrays.copyOf(suite, 2 * suite.length);
            compte = Arrays.copyOf(compte, 2 * compte.length);
        }
        suite[noeud] = enfants;
        diviser(enfants, debut, coupe, profondeur + 1);
        diviser(enfants + 1, coupe, fin, profondeur + 1);
    }

    private static int moitie(int debut, int fin) {
        return fin - debut <= FEUILLE_MAX ? -1 : (debut + fin) >>> 1;
    }

    /** Range les sphères de part et d'autre de la meilleure coupe, et rend son rang ; -1 si une feuille coûte moins. */
    private int couper(int debut, int fin, Boite centres, Boite boite) {
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
            Boite[] parts = new Boite[TRANCHES];
            int[] nombres = new int[TRANCHES];
            for (int i = debut; i < fin; i++) {
                int s = Spheres.PAS * feuilles[i];
                int t = tranche(g[s + a], bas[a], pas[a]);
                if (parts[t] == null) {
                    parts[t] = new Boite();
                }
                parts[t].ajouter(g[s], g[s + 1], g[s + 2], g[s + 3]);
                nombres[t]++;
            }
            // coût d'une coupe : somme, sur ses deux côtés, de l'aire fois le nombre de sphères
            double[] aDroite = new double[TRANCHES];
            Boite e = new Boite();
            int c = 0;
            for (int t = TRANCHES - 1; t > 0; t--) {
                c += nombres[t];
                e.ajouter(parts[t]);
                aDroite[t] = c == 0 ? Double.POSITIVE_INFINITY : e.aire() * c;
            }
            e = new Boite();
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
            if (tranche(g[Spheres.PAS * feuilles[i] + axe], bas[axe], pas[axe]) <= tranche) {
                i++;
            } else {
                int k = feuilles[i];
                feuilles[i] = feuilles[--j];
                feuilles[j] = k;
            }
        }
        return i == debut || i == fin ? moitie(debut, fin) : i;
    }

    private static int tranche(double x, double bas, double pas) {
        return Math.min(TRANCHES - 1, (int) ((x - bas) / pas));
    }
}
