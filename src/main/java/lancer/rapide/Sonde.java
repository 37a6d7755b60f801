package lancer.rapide;

import lancer.contrat.Compteurs;

/** Ce qu'un fil garde à côté de ses questions aux structures : la distance trouvée, une pile, ses comptes. */
final class Sonde {

    /** Distance du dernier contact trouvé, +∞ s'il n'y en a pas. */
    double distance;

    /** De quoi descendre un arbre. */
    final int[] pile = new int[Arbre.PROFONDEUR_MAX];
    final double[] entrees = new double[Arbre.PROFONDEUR_MAX];

    final Compteurs compteurs;

    Sonde(Compteurs compteurs) {
        this.compteurs = compteurs;
    }
}
