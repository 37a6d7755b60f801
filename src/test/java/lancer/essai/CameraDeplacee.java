package lancer.essai;

import lancer.Camera;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;

/** La caméra d'un étudiant qui a changé l'œil et le plan de l'écran, et rien d'autre. */
public final class CameraDeplacee extends Camera {

    private final Point oeil;
    private final double plan;

    public CameraDeplacee(int largeur, int hauteur, Point oeil, double plan) {
        super(largeur, hauteur);
        this.oeil = oeil;
        this.plan = plan;
    }

    @Override
    public Point getOeil() {
        return oeil;
    }

    @Override
    public Point getEcran(double xe, double ye) {
        return new Point(getX(xe), getY(ye), plan);
    }

    @Override
    public Rayon getRayon(double xe, double ye) {
        return new Rayon(getEcran(xe, ye), new Vecteur(oeil, getEcran(xe, ye)));
    }
}
