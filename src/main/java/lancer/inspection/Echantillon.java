package lancer.inspection;

import lancer.Couleur;

/** Un rayon parti de l'écran, et ce qu'il voit, autant de fois qu'il compte. */
public final class Echantillon {

    /** Point de l'écran, en pixels depuis le coin en haut à gauche ; poids dans une somme pesée, ou 1 ; couleur. */
    public final double xe;
    public final double ye;
    final double poids;
    public final Couleur couleur;

    Echantillon(double xe, double ye, double poids, Couleur couleur) {
        this.xe = xe;
        this.ye = ye;
        this.poids = poids;
        this.couleur = couleur;
    }

    /** Vrai s'il est pris dans ce pixel, et non dans un voisin qui le partage. */
    public boolean estDans(int x, int y) {
        return Math.floor(xe) == x && Math.floor(ye) == y;
    }
}
