package lancer.rapide;

import java.util.Arrays;
import lancer.contrat.Recherche;

/**
 * Hiérarchie de boîtes (BVH) autour des enveloppes ; la racine est le nœud 0. Chaque division suit l'heuristique de
 * l'aire (SAH, MacDonald et Booth, 1990), parmi {@value #TRANCHES} tranches par axe (Wald, 2007). Une boîte est notée par
 * son centre et ses demi-côtés.
 */
final class Arbre {

    /** Élargissement d'une boîte et d'un rayon, en part de leurs coordonnées. */
    static final double MARGE = 0x1.0p-46;

    /** Profondeur maximale. Les trente-deux derniers niveaux divisent en deux moitiés égales. */
    static final int PROFONDEUR_MAX = 96;

    /** Nombres par nœud dans {@link #boites} : le centre, puis les demi-côtés. */
    static final int PAS = 6;

    private static final int TRANCHES = 16;

    /** Taille des feuilles, et coût d'un nœud en objets demandés. */
    private static final int FEUILLE_MIN = 2;
    private static final int FEUILLE_MAX = 8;
    private static final double COUT_NOEUD = 1;

    private final double[] g;
    double[] boites;
    /** Premier des deux enfants, qui se suivent ; pour une feuille, première place dans {@link #feuilles}. */
    int[] suite;
    /** Nombre d'objets d'une feuille, 0 pour un autre nœud. */
    byte[] compte;
    final int[] feuilles;
    private int nombre;

    /** @throws java.util.concurrent.CancellationException si ce fil est interrompu */
    Arbre(Enveloppes enveloppes) {
        g = enveloppes.geometrie;
        feuilles = enveloppes.bornes.clone();
        int places = Math.max(2, feuilles.length);
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
            int s = Enveloppes.PAS * feuilles[i];
            boite.ajouter(g[s], g[s + 1], g[s + 2], g[s + 3]);
            centres.ajouter(g[s], g[s + 1], g[s + 2], 0);
        }
        boite.noter(boites, PAS * noeud);
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

    /** Range les objets de part et d'autre de la meilleure coupe, et rend son rang ; −1 si une feuille coûte moins. */
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
                int s = Enveloppes.PAS * feuilles[i];
                int t = tranche(g[s + a], bas[a], pas[a]);
                if (parts[t] == null) {
                    parts[t] = new Boite();
                }
                parts[t].ajouter(g[s], g[s + 1], g[s + 2], g[s + 3]);
                nombres[t]++;
            }
            // coût d'une coupe : somme, sur ses deux côtés, de l'aire fois le nombre d'objets
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
            if (tranche(g[Enveloppes.PAS * feuilles[i] + axe], bas[axe], pas[axe]) <= tranche) {
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

    /** Une boîte de sphères. */
    private static final class Boite {

        private double xMin = Double.POSITIVE_INFINITY;
        private double yMin = Double.POSITIVE_INFINITY;
        private double zMin = Double.POSITIVE_INFINITY;
        private double xMax = Double.NEGATIVE_INFINITY;
        private double yMax = Double.NEGATIVE_INFINITY;
        private double zMax = Double.NEGATIVE_INFINITY;

        void ajouter(double x, double y, double z, double r) {
            xMin = Math.min(xMin, x - r);
            yMin = Math.min(yMin, y - r);
            zMin = Math.min(zMin, z - r);
            xMax = Math.max(xMax, x + r);
            yMax = Math.max(yMax, y + r);
            zMax = Math.max(zMax, z + r);
        }

        /** @param autre {@code null} pour une boîte vide */
        void ajouter(Boite autre) {
            if (autre != null) {
                ajouter(autre.xMin, autre.yMin, autre.zMin, 0);
                ajouter(autre.xMax, autre.yMax, autre.zMax, 0);
            }
        }

        /** La moitié de l'aire. */
        double aire() {
            double a = xMax - xMin;
            double b = yMax - yMin;
            double c = zMax - zMin;
            return a * b + b * c + c * a;
        }

        /** Note à cette place le centre et les demi-côtés, élargis de la marge. */
        void noter(double[] boites, int place) {
            double marge = MARGE * Math.max(Math.max(Math.max(-xMin, xMax), Math.max(-yMin, yMax)), Math.max(-zMin, zMax));
            boites[place] = (xMin + xMax) / 2;
            boites[place + 1] = (yMin + yMax) / 2;
            boites[place + 2] = (zMin + zMax) / 2;
            boites[place + 3] = (xMax - xMin) / 2 + marge;
            boites[place + 4] = (yMax - yMin) / 2 + marge;
            boites[place + 5] = (zMax - zMin) / 2 + marge;
        }
    }
}
