package lancer;

/**
 * D'un pixel à son rayon (cours, « Écran, œil et projection »). L'écran est dans le plan z = 0, l'œil derrière lui, la
 * scène devant (z &gt; 0).
 */
public class Camera {

    private final int largeur;
    private final int hauteur;
    private final Point oeil;

    public Camera(int largeur, int hauteur) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        //{ compléter : la distance focale, à partir de Constantes.ECHELLE et de Constantes.CHAMP, qui est en degrés
        double focale = Constantes.ECHELLE / 2 / Math.tan(Math.toRadians(Constantes.CHAMP / 2));
        //= double focale = 0;
        //}
        oeil = new Point(0, 0, -focale);
    }

    /**
     * Le rayon qui part du point (xe, ye) de l'écran et s'éloigne de l'œil.
     *
     * @param xe en pixels depuis la gauche
     * @param ye en pixels depuis le haut
     */
    public Rayon getRayon(double xe, double ye) {
        //{ compléter : passer des coordonnées de l'écran (xe, ye) à celles de la scène (x, y, 0)
        double x = (xe - largeur / 2.0) * Constantes.ECHELLE / largeur;
        double y = (hauteur / 2.0 - ye) * Constantes.ECHELLE / largeur;
        //= double x = 0;
        //= double y = 0;
        //}
        Point ecran = new Point(x, y, 0);
        return new Rayon(ecran, new Vecteur(oeil, ecran));
    }
}
