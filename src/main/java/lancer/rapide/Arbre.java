package lancer.rapide;

import java.util.Arrays;
import lancer.contrat.Recherche;

/**
 * Hiérarchie de boîtes (BVH) autour des enveloppes ; la racine est le nœud 0. Les centres sont rangés le long de l'axe
 * où ils s'étendent le plus. La coupe est la moins chère selon l'heuristique de l'aire (SAH, MacDonald et Booth, 1990).
 * Une boîte est notée par son centre et ses demi-côtés.
 */
final class Arbre {

    /** Élargissement d'une boîte et d'un rayon, en part de leurs coordonnées. */
    static final double MARGE = 0x1.0p-46;

    /** Profondeur maximale. Les trente-deux derniers niveaux divisent en deux moitiés égales. */
    static final int PROFONDEUR_MAX = 96;

    /** Nombres par nœud dans {@link #boites} : le centre, puis les demi-côtés. */
    static final int PAS = 6;

    /** Taille maximale d'une feuille, et coût d'un nœud en objets demandés. */
    private static final int FEUILLE_MAX = 8;
    private static final double COUT_NOEUD = 2;

    /** Nombre de rangs différents le long d'un axe. */
    private static final double FINESSE = 1 << 30;

    private final double[] g;
    final double[] boites;
    /** Premier des deux enfants, qui se suivent ; pour une feuille, première place dans {@link #feuilles}. */
    final int[] suite;
    /** Nombre d'objets d'une feuille, 0 pour un autre nœud. */
    final byte[] compte;
    final int[] feuilles;
    private int nombre;

    /** @throws java.util.concurrent.CancellationException si ce fil est interrompu */
    Arbre(Enveloppes enveloppes) {
        g = enveloppes.geometrie;
        feuilles = enveloppes.petits.clone();
        int places = 2 * feuilles.length;
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
        Boite boite = new Boite();
        Boite centres = new Boite();
        for (int i = debut; i < fin; i++) {
            boite.ajouter(Enveloppes.PAS * feuilles[i], 1);
            centres.ajouter(Enveloppes.PAS * feuilles[i], 0);
        }
        boite.noter(PAS * noeud);
        int coupe = (debut + fin) >>> 1;
        boolean feuille = fin - debut <= FEUILLE_MAX;
        if (profondeur <= PROFONDEUR_MAX - Integer.SIZE) {
            trier(debut, fin, centres);
            coupe = couper(debut, fin, feuille ? boite.aire() * (fin - debut - COUT_NOEUD) : Double.POSITIVE_INFINITY);
            feuille = coupe < 0;
        }
        if (feuille) {
            suite[noeud] = debut;
            compte[noeud] = (byte) (fin - debut);
        } else {
            int enfants = nombre;
            nombre += 2;
            suite[noeud] = enfants;
            diviser(enfants, debut, coupe, profondeur + 1);
            diviser(enfants + 1, coupe, fin, profondeur + 1);
        }
    }

    /** Range ces objets dans l'ordre de leurs centres, le long du plus grand côté de la boîte des centres. */
    private void trier(int debut, int fin, Boite centres) {
        int axe = centres.plusLong();
        double bas = centres.bas[axe];
        double parRang = FINESSE / (centres.haut[axe] - bas);
        long[] ordre = new long[fin - debut];
        for (int i = debut; i < fin; i++) {
            long rang = (long) ((g[Enveloppes.PAS * feuilles[i] + axe] - bas) * parRang);
            ordre[i - debut] = rang << Integer.SIZE | feuilles[i];
        }
        Arrays.sort(ordre);
        for (int i = debut; i < fin; i++) {
            feuilles[i] = (int) ordre[i - debut];
        }
    }

    /**
     * La première place du second côté de la coupe la moins chère. Le coût est la somme, sur les deux côtés, de l'aire
     * fois le nombre d'objets.
     *
     * @return −1 si aucune ne coûte moins que {@code auPlus}
     */
    private int couper(int debut, int fin, double auPlus) {
        double[] coutApres = new double[fin - debut];
        Boite apres = new Boite();
        for (int i = fin - 1; i > debut; i--) {
            apres.ajouter(Enveloppes.PAS * feuilles[i], 1);
            coutApres[i - debut] = apres.aire() * (fin - i);
        }
        Boite avant = new Boite();
        double meilleur = auPlus;
        int coupe = -1;
        for (int i = debut + 1; i < fin; i++) {
            avant.ajouter(Enveloppes.PAS * feuilles[i - 1], 1);
            double cout = avant.aire() * (i - debut) + coutApres[i - debut];
            if (cout < meilleur) {
                meilleur = cout;
                coupe = i;
            }
        }
        return coupe;
    }

    /** La boîte de plusieurs enveloppes. */
    private final class Boite {

        final double[] bas = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        final double[] haut = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};

        /** Ajoute l'enveloppe notée à cette place. @param part celle de son rayon, 0 pour le centre seul */
        void ajouter(int place, double part) {
            double r = part * g[place + 3];
            for (int a = 0; a < 3; a++) {
                bas[a] = Math.min(bas[a], g[place + a] - r);
                haut[a] = Math.max(haut[a], g[place + a] + r);
            }
        }

        int plusLong() {
            double x = haut[0] - bas[0];
            double y = haut[1] - bas[1];
            double z = haut[2] - bas[2];
            if (x >= y && x >= z) {
                return 0;
            }
            return y >= z ? 1 : 2;
        }

        /** La moitié de l'aire. */
        double aire() {
            double x = haut[0] - bas[0];
            double y = haut[1] - bas[1];
            double z = haut[2] - bas[2];
            return x * y + y * z + z * x;
        }

        /** Note à cette place de {@link #boites} le centre et les demi-côtés, élargis de la marge. */
        void noter(int place) {
            double loin = Math.max(Enveloppes.plusGrande(bas[0], bas[1], bas[2]),
                    Enveloppes.plusGrande(haut[0], haut[1], haut[2]));
            for (int a = 0; a < 3; a++) {
                boites[place + a] = (bas[a] + haut[a]) / 2;
                boites[place + 3 + a] = (haut[a] - bas[a]) / 2 + MARGE * loin;
            }
        }
    }
}
