package lancer.essai;

import lancer.Camera;
import lancer.Couleur;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Vue;

/**
 * Ce que montre une scène d'une sphère, de la géométrie et sans intersection calculée : l'œil E, une direction V, et la distance l
 * du centre à la droite (E, V), perpendiculaire prise comme un vecteur.
 */
public final class Analytique {

    private final Camera camera;
    private final Point C;
    private final double r;

    public Analytique(Camera camera, Point C, double r) {
        this.camera = camera;
        this.C = C;
        this.r = r;
    }

    /** La direction dans laquelle l'œil voit ce point de l'écran. */
    public Vecteur regard(double xe, double ye) {
        return new Vecteur(Camera.OEIL, camera.getEcran(xe, ye)).normalized();
    }

    private double carreDeL(Vecteur V) {
        Vecteur f = new Vecteur(Camera.OEIL, C);
        return f.sub(V.mul(f.dot(V))).norme2();
    }

    public boolean touche(Vecteur V) {
        return carreDeL(V) <= r * r;
    }

    /** La normale là où la droite entre dans la sphère, ou là où elle en sort. */
    public Vecteur normale(Vecteur V, boolean sortie) {
        Vecteur f = new Vecteur(Camera.OEIL, C);
        double h = Math.sqrt(r * r - carreDeL(V));
        Vecteur perpendiculaire = f.sub(V.mul(f.dot(V)));
        return V.mul(sortie ? h : -h).sub(perpendiculaire).div(r);
    }

    public Point point(Vecteur normale) {
        return C.add(normale.mul(r));
    }

    /** La lampe, de couleur 1, est à l'œil : Kd √(1 − l²/r²), et le ciel autour. */
    public Vue vueDeLaLampe(double kd) {
        return (xe, ye) -> {
            Vecteur V = regard(xe, ye);
            double c = 1 - carreDeL(V) / (r * r);
            return c >= 0 ? new Couleur(kd * Math.sqrt(c)) : ciel(V);
        };
    }

    public static Couleur ciel(Vecteur V) {
        return new Rayon(Camera.OEIL, V).getSkyColor();
    }
}
