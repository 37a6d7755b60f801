package lancer.inspection;

import lancer.Couleur;

/** Un rayon parti de l'écran et la couleur qu'il voit, avec son poids dans la couleur du pixel. */
public final class Echantillon {

    /** Point de l'écran, en pixels depuis le coin en haut à gauche ; poids dans la somme, ou 1 ; couleur. */
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

    /** Dit si ce point est dans ce pixel, et non dans un pixel voisin qui le partage. */
    public boolean estDans(int x, int y) {
        return Math.floor(xe) == x && Math.floor(ye) == y;
    }
}
