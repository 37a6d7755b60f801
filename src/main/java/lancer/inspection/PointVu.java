package lancer.inspection;

import lancer.Couleur;

/** Un échantillon d'un pixel : un point de l'écran, et la couleur, non limitée, qui y est vue. */
final class PointVu {

    /** Abscisse et ordonnée, en pixels depuis le coin en haut à gauche. */
    final double xe;
    final double ye;

    /** Dit si ce point est dans un pixel voisin, qui le partage. */
    final boolean partage;
    final Couleur couleur;

    PointVu(double xe, double ye, boolean partage, Couleur couleur) {
        this.xe = xe;
        this.ye = ye;
        this.partage = partage;
        this.couleur = couleur;
    }
}
