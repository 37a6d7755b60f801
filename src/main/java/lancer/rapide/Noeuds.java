package lancer.rapide;

/** Les nœuds d'un {@link Arbre} construit ; la racine est le nœud 0. Immuable. */
final class Noeuds {

    /** Part des coordonnées dont s'élargissent une boîte et un rayon : 2,7 fois ce que demandent les arrondis. */
    static final double MARGE = 0x1.0p-46;

    /** Profondeur au plus : les trente-deux derniers étages se coupent en deux moitiés égales. */
    static final int PROFONDEUR_MAX = 96;

    /** Nombres par nœud dans {@link #boites} : minimums, puis maximums. */
    static final int PAS = 6;

    final double[] boites;
    /** Premier des deux enfants, qui se suivent ; ou, d'une feuille, la première place dans {@link #feuilles}. */
    final int[] suite;
    /** Nombre de sphères d'une feuille, 0 si ce n'en est pas une. */
    final byte[] compte;
    final int[] feuilles;

    Noeuds(double[] boites, int[] suite, byte[] compte, int[] feuilles) {
        this.boites = boites;
        this.suite = suite;
        this.compte = compte;
        this.feuilles = feuilles;
    }
}
