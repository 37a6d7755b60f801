package lancer;

/**
 * Passage d'un pixel à son rayon (cours, « Écran, œil et projection »). L'écran est dans le plan z = 0, l'œil derrière
 * lui, la scène devant (z &gt; 0). Une {@link CameraPlacee} les place ailleurs. Immuable.
 */
public class Camera {

    /** Distance de l'œil à l'écran, en unités de la scène : (ECHELLE / 2) / tan(CHAMP / 2). */
    public static final double FOCALE = (Constantes.ECHELLE / 2) / Math.tan(Math.toRadians(Constantes.CHAMP / 2));

    /** Position de l'œil, en unités de la scène. */
    public static final Point OEIL = new Point(0, 0, -FOCALE);

    private final int largeur;
    private final int hauteur;

    /** @throws IllegalArgumentException si l'image n'a pas une colonne et une ligne de pixels au moins */
    public Camera(int largeur, int hauteur) {
        if (largeur < 1 || hauteur < 1) {
            throw new IllegalArgumentException("taille d'image impossible : " + largeur + " × " + hauteur);
        }
        this.largeur = largeur;
        this.hauteur = hauteur;
    }

    public int getLargeur() {
        return largeur;
    }

    public int getHauteur() {
        return hauteur;
    }

    /** L'abscisse dans la scène du point de l'écran d'abscisse {@code xe}, en pixels depuis la gauche. */
    public double getX(double xe) {
        return (xe - largeur / 2.0) * Constantes.ECHELLE / largeur;
    }

    /** L'ordonnée dans la scène du point de l'écran d'ordonnée {@code ye}, en pixels depuis le haut. */
    public double getY(double ye) {
        return (hauteur / 2.0 - ye) * Constantes.ECHELLE / largeur;
    }

    public Point getOeil() {
        return OEIL;
    }

    /** Le point de l'écran en (xe, ye), en pixels depuis la gauche et depuis le haut. */
    public Point getEcran(double xe, double ye) {
        return new Point(getX(xe), getY(ye), 0);
    }

    /** Où l'œil voit p : x à droite, y en haut, z droit devant lui, perpendiculaire à l'écran. */
    public Vecteur depuisLOeil(Point p) {
        return new Vecteur(getOeil(), p);
    }

    /**
     * Le rayon qui part de l'écran en (xe, ye) et s'éloigne de l'œil.
     *
     * @param xe en pixels depuis la gauche ; le centre du pixel i est i + 0,5
     * @param ye en pixels depuis le haut ; le centre de la ligne j est j + 0,5
     */
    public Rayon getRayon(double xe, double ye) {
        Point ecran = getEcran(xe, ye);
        return new Rayon(ecran, new Vecteur(getOeil(), ecran));
    }
}
