package lancer;

/**
 * D'un pixel à son rayon (cours, « Écran, œil et projection »). L'écran est dans le plan z = 0, l'œil derrière lui, la scène devant
 * (z &gt; 0).
 */
public class Camera {

    private final int largeur;
    private final int hauteur;
    private final Point oeil;

    public Camera(int largeur, int hauteur) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        double focale = Constantes.ECHELLE / 2 / Math.tan(Math.toRadians(Constantes.CHAMP / 2));
        oeil = new Point(0, 0, -focale);
    }

    /**
     * Le rayon qui part du point (xe, ye) de l'écran et s'éloigne de l'œil.
     *
     * @param xe en pixels depuis la gauche
     * @param ye en pixels depuis le haut
     */
    public Rayon getRayon(double xe, double ye) {
        double x = (xe - largeur / 2.0) * Constantes.ECHELLE / largeur;
        double y = (ye - hauteur / 2.0) * Constantes.ECHELLE / largeur;
        Point ecran = new Point(x, y, 0);
        return new Rayon(ecran, new Vecteur(oeil, ecran));
    }
}
