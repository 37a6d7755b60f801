package lancer.fenetre.etat;

/** Un pixel de l'image : sa colonne, depuis 0, et sa ligne, depuis 0 en haut. */
public final class Pixel {

    public final int x;
    public final int y;

    public Pixel(int x, int y) {
        this.x = x;
        this.y = y;
    }

    /** Le plus proche des pixels d'une image de cette taille. */
    Pixel dans(int largeur, int hauteur) {
        return new Pixel(Math.max(0, Math.min(largeur - 1, x)), Math.max(0, Math.min(hauteur - 1, y)));
    }

    @Override
    public boolean equals(Object autre) {
        return autre instanceof Pixel && x == ((Pixel) autre).x && y == ((Pixel) autre).y;
    }

    @Override
    public int hashCode() {
        return 31 * x + y;
    }
}
