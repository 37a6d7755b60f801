package lancer;

/** Une sphère (cours, « Intersection de rayons et de sphères »). */
public class Sphere extends Objet3D {

    private final Point centre;
    private final double rayon;

    /** @param rayon demi-diamètre */
    public Sphere(Point centre, double rayon) {
        this.centre = centre;
        this.rayon = rayon;
    }

    public Point getCentre() {
        return centre;
    }

    public double getRayon() {
        return rayon;
    }

    @Override
    public double getIntersectionDistance(Rayon incident) {
        Vecteur CP = new Vecteur(centre, incident.getP());
        double b = 2 * CP.dot(incident.getV());
        double c = CP.norme2() - rayon * rayon;
        double delta = b * b - 4 * c;
        double distance = Constantes.INFINI;
        if (delta >= 0) {
            double racine = Math.sqrt(delta);
            if (-b - racine > 0) {
                distance = (-b - racine) / 2;
            } else if (-b + racine > 0) {
                distance = (-b + racine) / 2;
            }
        }
        incident.setContact(this, distance);
        return distance;
    }

    @Override
    public Vecteur getNormale(Point contact) {
        return new Vecteur(contact, centre).normalized();
    }

    @Override
    public String toString() {
        return "Sphere(" + centre + ", " + rayon + ")";
    }
}
