package lancer.rapide;

import lancer.contrat.Recherche;

/**
 * Hiérarchie de boîtes (BVH) autour des enveloppes ; la racine est le nœud 0. Une boîte, notée par son centre et ses
 * demi-côtés, est coupée au milieu de l'axe où les centres s'étendent le plus.
 */
final class Arbre {

    /** Élargissement d'une boîte et d'un rayon, en part de leurs coordonnées. */
    static final double MARGE = 0x1.0p-46;

    /** Profondeur maximale. Les trente-deux derniers niveaux divisent en deux moitiés égales. */
    static final int PROFONDEUR_MAX = 96;

    /** Nombres par nœud dans {@link #boites} : le centre, puis les demi-côtés. */
    static final int PAS = 6;

    /** Taille maximale d'une feuille. */
    private static final int FEUILLE_MAX = 5;

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
        if (fin - debut <= FEUILLE_MAX) {
            suite[noeud] = debut;
            compte[noeud] = (byte) (fin - debut);
        } else {
            int coupe = separer(debut, fin, centres);
            if (profondeur > PROFONDEUR_MAX - Integer.SIZE || coupe == debut) {
                coupe = (debut + fin) >>> 1;
            }
            int enfants = nombre;
            nombre += 2;
            suite[noeud] = enfants;
            diviser(enfants, debut, coupe, profondeur + 1);
            diviser(enfants + 1, coupe, fin, profondeur + 1);
        }
    }

    /** Sépare ces objets au milieu du plus grand côté de la boîte des centres. @return la première place d'après */
    private int separer(int debut, int fin, Boite centres) {
        int axe = centres.plusLong();
        double milieu = (centres.bas[axe] + centres.haut[axe]) / 2;
        int coupe = debut;
        for (int i = debut; i < fin; i++) {
            int k = feuilles[i];
            if (g[Enveloppes.PAS * k + axe] < milieu) {
                feuilles[i] = feuilles[coupe];
                feuilles[coupe++] = k;
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
