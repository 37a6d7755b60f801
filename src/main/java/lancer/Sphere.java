package lancer;

import lancer.precision.Intersection;
import lancer.precision.Norme;

/** Une sphère (cours, « Intersection de rayons et de sphères »). Sa géométrie est immuable. */
public class Sphere extends Objet3D {

    /** Normale que {@link #getNormale} rend au centre, où aucune n'est définie. */
    private static final Vecteur VERS_L_OEIL = new Vecteur(0, 0, -1);

    private final Point centre;
    private final double rayon;

    /** @throws IllegalArgumentException si le rayon n'est pas un nombre fini strictement positif */
    public Sphere(Point centre, double rayon) {
        if (!(rayon > 0 && rayon <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("rayon de sphère impossible : " + rayon);
        }
        this.centre = centre;
        this.rayon = rayon;
    }

    public Point getCentre() {
        return centre;
    }

    /** Le rayon, en unités de la scène. */
    public double getRayon() {
        return rayon;
    }

    /**
     * {@inheritDoc} Une sphère est sa propre enveloppe. Une classe dérivée peut déborder : elle n'en a pas, sauf si
     * elle en déclare une.
     */
    @Override
    public Sphere getEnveloppe() {
        return getClass() == Sphere.class ? this : null;
    }

    @Override
    public double getIntersectionDistance(Rayon incident) {
        Point P = incident.getP();
        Vecteur V = incident.getV();
        double d = Intersection.distance(P.x, P.y, P.z, V.x, V.y, V.z, centre.x, centre.y, centre.z, rayon);
        incident.setContact(this, d);
        return d;
    }

    /**
     * {@inheritDoc} Ce point est C + r·(X − C)/|X − C|, calculé sous la forme X − e·(X − C), où e = 1 − r/|X − C| est
     * presque nul. Soit u = 2⁻⁵³ : l'écart à la surface est inférieur à 4 u (r + |C|), quelle que soit la longueur du
     * rayon. L'écart de X = P + tV est de 2 u |X − P| (Pharr, Jakob et Humphreys, <i>Physically Based Rendering</i>, 4e
     * éd., § 6.8) : si t est inférieur à r, X est plus juste, et c'est lui qui est rendu. Le centre et un point qui
     * n'est pas fini sont rendus tels quels.
     */
    @Override
    public Point getPointDeSurface(Point contact, double distance) {
        double x = contact.x - centre.x;
        double y = contact.y - centre.y;
        double z = contact.z - centre.z;
        double carre = x * x + y * y + z * z;
        if (carre >= Norme.CARRE_MIN && carre <= Norme.CARRE_MAX) {
            double e = distance < rayon ? 0 : Norme.ecart(carre, rayon);
            // un seul point, même si e est nul : le compilateur ne l'alloue alors pas
            return new Point(contact.x - e * x, contact.y - e * y, contact.z - e * z);
        }
        double norme = new Vecteur(centre, contact).norme();
        return distance >= rayon && norme > 0 && norme <= Double.MAX_VALUE
                ? centre.add(rayon, new Vecteur(centre, contact).normalized()) : contact;
    }

    /** {@inheritDoc} Un arrondi peut placer le contact au centre : la normale y est, par convention, (0, 0, −1). */
    @Override
    public Vecteur getNormale(Point contact) {
        double k = 1 / rayon;
        Vecteur n = new Vecteur((contact.x - centre.x) * k, (contact.y - centre.y) * k, (contact.z - centre.z) * k);
        if (Math.abs(n.norme2() - 1) <= Norme.PRESQUE_UN) {
            return n.normalized();
        }
        Vecteur exact = new Vecteur(centre, contact);
        return exact.norme() == 0 ? VERS_L_OEIL : exact.normalized();
    }

    @Override
    public String toString() {
        return "Sphere(" + centre + ", " + rayon + ")";
    }
}
