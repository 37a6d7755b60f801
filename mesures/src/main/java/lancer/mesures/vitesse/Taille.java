package lancer.mesures.vitesse;

/** La taille des images mesurées, et combien de fils les dessinent. */
final class Taille {

    /** Au-delà, une image de 35 pavés n'occuperait plus tous les fils jusqu'au bout. */
    private static final int FILS_MAX = 4;

    /** Celle de toutes les courbes, dessinée comme par le programme sur tous les cœurs. */
    static final Taille COURBES = new Taille(200, 150, Math.min(FILS_MAX, Runtime.getRuntime().availableProcessors()));

    final int largeur;
    final int hauteur;
    final int fils;

    Taille(int largeur, int hauteur, int fils) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.fils = fils;
    }

    int pixels() {
        return largeur * hauteur;
    }
}
