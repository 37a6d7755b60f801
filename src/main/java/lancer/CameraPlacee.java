package lancer;

/**
 * Une caméra dont la section {@code [Camera]} place l'œil. Son écran est perpendiculaire à la droite de l'œil à la
 * cible ; sa verticale est dans le plan de cette droite et de l'axe y. Immuable.
 */
public final class CameraPlacee extends Camera {

    /** Plus grande distance de l'œil à l'écran : celle des points d'une scène. */
    private static final double FOCALE_MAX = 1e100;

    private final Point oeil;
    private final double focale;
    private final Vecteur droite;
    private final Vecteur haut;
    private final Vecteur avant;

    /**
     * @param axe du regard, de longueur quelconque, ni nul ni le long de l'axe y
     * @param champ angle sous lequel l'œil voit la largeur de l'écran, en degrés, entre 0 et 180 exclus
     */
    public CameraPlacee(int largeur, int hauteur, Point oeil, Vecteur axe, double champ) {
        super(largeur, hauteur);
        this.oeil = oeil;
        focale = focale(champ);
        double plat = Math.hypot(axe.x, axe.z);
        avant = axe.normalized();
        droite = new Vecteur(axe.z / plat, 0, -axe.x / plat);
        haut = new Vecteur(avant.y * droite.z, plat / axe.norme(), -avant.y * droite.x);
    }

    /** La distance de l'œil à l'écran pour ce champ, en unités de la scène. */
    public static double focale(double champ) {
        return Math.min(FOCALE_MAX, (Constantes.ECHELLE / 2) / Math.tan(Math.toRadians(champ / 2)));
    }

    @Override
    public Point getOeil() {
        return oeil;
    }

    @Override
    public Point getEcran(double xe, double ye) {
        return oeil.add(versLEcran(xe, ye));
    }

    @Override
    public Vecteur depuisLOeil(Point p) {
        Vecteur v = new Vecteur(oeil, p);
        return new Vecteur(v.dot(droite), v.dot(haut), v.dot(avant));
    }

    @Override
    public Rayon getRayon(double xe, double ye) {
        return new Rayon(getEcran(xe, ye), versLEcran(xe, ye));
    }

    /** Le vecteur de l'œil à l'écran : loin de l'origine, la différence de deux points perdrait ses chiffres. */
    private Vecteur versLEcran(double xe, double ye) {
        return droite.mul(getX(xe)).add(haut.mul(getY(ye))).add(avant.mul(focale));
    }
}
