package lancer.essai;

import lancer.Constantes;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;

/** Le plan sans fin qu'écrirait un élève : il n'a que les deux méthodes qu'un objet doit donner. */
public class Plan extends Objet3D {

    private final Point A;
    private final Vecteur N;

    /** @param N de longueur 1 */
    public Plan(Point A, Vecteur N) {
        this.A = A;
        this.N = N;
    }

    @Override
    public double getIntersectionDistance(Rayon incident) {
        double t = A.sub(incident.getP()).dot(N) / incident.getV().dot(N);
        double d = t > 0 ? t : Constantes.INFINI;
        incident.setContact(this, d);
        return d;
    }

    @Override
    public Vecteur getNormale(Point contact) {
        return N;
    }
}
