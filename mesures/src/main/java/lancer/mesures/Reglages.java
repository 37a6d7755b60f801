package lancer.mesures;

/** Comment mesurer une scène. */
final class Reglages {

    final int largeur;
    final int hauteur;
    final int fils;

    /** Temps accordé à la scène, lecture et préparation non comprises. */
    final long dureeNs;

    /** Temps d'une image au-delà duquel la scène n'est pas mesurée. */
    final long limiteNs;

    Reglages(int largeur, int hauteur, int fils, long dureeNs, long limiteNs) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.fils = fils;
        this.dureeNs = dureeNs;
        this.limiteNs = limiteNs;
    }
}
