package lancer;

/**
 * Une demi-droite : un point de départ P et un vecteur directeur V, normé (cours, « Représentation des rayons »). Un
 * rayon retient aussi le contact que {@link Objet3D#getIntersectionDistance} y a noté en dernier.
 */
public class Rayon {

    private final Point P;
    private final Vecteur V;
    private double distance = Constantes.INFINI;
    private Objet3D objet;

    /** Le rayon qui part de {@code p1} et va vers {@code p2}. */
    public Rayon(Point p1, Point p2) {
        //{ compléter : le point de départ, et le vecteur normalisé qui va de p1 à p2
        P = p1;
        V = new Vecteur(p1, p2).normalized();
        //= P = new Point();
        //= V = new Vecteur();
        //}
    }

    /** Le rayon qui part de {@code p} dans la direction de {@code v}, qui n'est pas forcément normé. */
    public Rayon(Point p, Vecteur v) {
        //{ compléter : le point de départ, et le vecteur v normalisé
        P = p;
        V = v.normalized();
        //= P = new Point();
        //= V = new Vecteur();
        //}
    }

    public Point getP() {
        return P;
    }

    public Vecteur getV() {
        return V;
    }

    /** La distance du contact noté, +∞ s'il n'y en a pas. */
    public double getDistance() {
        return distance;
    }

    /** L'objet du contact noté, {@code null} s'il n'y en a pas. */
    public Objet3D getObjet() {
        return objet;
    }

    /** Note un contact, à la place du précédent. */
    public void setContact(Objet3D objet, double distance) {
        this.objet = distance == Constantes.INFINI ? null : objet;
        this.distance = distance;
    }

    /** Le point de contact à la distance notée, {@code null} si elle est infinie. */
    public PointContact calcContact() {
        //{ compléter : calculer le point à partir de P, de V et de la distance, puis construire le PointContact
        if (distance == Constantes.INFINI) {
            return null;
        }
        return new PointContact(P.add(V.mul(distance)), objet, distance);
        //= return null;
        //}
    }

    /** La couleur du ciel dans la direction du rayon. */
    public Couleur getSkyColor() {
        if (V.y > 0) {
            Couleur horizon = new Couleur(0.7, 0.7, 1.0);
            Couleur zenith = new Couleur(0, 0, 1);
            return horizon.mul(1 - V.y).add(zenith.mul(V.y));
        }
        return new Couleur(0.5, 0.4 + 0.2 * V.y, 0.1);
    }
}
