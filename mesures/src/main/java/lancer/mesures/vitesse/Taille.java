package lancer.mesures.vitesse;

/** La taille des images mesurées, et le nombre de fils. */
final class Taille {

    final int largeur;
    final int hauteur;
    final int fils = Runtime.getRuntime().availableProcessors();

    Taille(int largeur, int hauteur) {
        this.largeur = largeur;
        this.hauteur = hauteur;
    }

    int pixels() {
        return largeur * hauteur;
    }

    @Override
    public String toString() {
        return largeur + "x" + hauteur;
    }
}
