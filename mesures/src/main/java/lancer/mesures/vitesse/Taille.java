package lancer.mesures.vitesse;

import lancer.Constantes;

/** La taille des images mesurées, et le nombre de fils. */
final class Taille {

    static final Taille PUBLIEE = new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);

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
