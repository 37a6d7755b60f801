package lancer;

/** Une sphère (cours, « Intersection de rayons et de sphères »). Sa géométrie est immuable. */
public class Sphere extends Objet3D {

    /** La normale convenue au centre même : vers l'œil. */
    private static final Vecteur VERS_L_OEIL = new Vecteur(0, 0, -1);

    private final Point centre;
    private final double rayon;

    /**
     * @param rayon demi-diamètre, en unités de la scène
     * @throws IllegalArgumentException si le rayon n'est pas un nombre fini strictement positif
     */
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

    /** Le demi-diamètre. */
    public double getRayon() {
        return rayon;
    }

    @Override
    public double getIntersectionDistance(Rayon incident) {
        Point P = incident.getP();
        Vecteur V = incident.getV();
        double d = distance(P.x, P.y, P.z, V.x, V.y, V.z, centre.x, centre.y, centre.z, rayon);
        incident.setContact(this, d);
        return d;
    }

    /**
     * La plus petite distance strictement positive de P à la sphère le long de V, de longueur 1 : +∞ s'il n'y en a pas ;
     * une tangente est un contact ; de l'intérieur, c'est la sortie.
     *
     * <p>Avec f = C − P et b = f·V, la demi-corde est h = √(r² − |f − bV|²) : le discriminant pris sur la perpendiculaire
     * ne soustrait pas deux grands carrés, et reste juste pour une sphère petite ou lointaine (Haines, Günther et
     * Akenine-Möller, <i>Precision Improvements for Ray/Sphere Intersection</i>, Ray Tracing Gems, 2019, ch. 7). Les racines
     * b − h et b + h ont pour produit c = |f|² − r² : celle qui soustrairait deux nombres voisins s'obtient en divisant c
     * par l'autre. Juste tant que les longueurs sont entre 1e-150 et 1e150.
     */
    public static double distance(double px, double py, double pz, double vx, double vy, double vz,
            double cx, double cy, double cz, double r) {
        double fx = cx - px;
        double fy = cy - py;
        double fz = cz - pz;
        double b = fx * vx + fy * vy + fz * vz;
        double lx = fx - b * vx;
        double ly = fy - b * vy;
        double lz = fz - b * vz;
        double h2 = r * r - (lx * lx + ly * ly + lz * lz);
        // écrit ainsi, NaN veut dire « rien » lui aussi
        if (!(h2 >= 0)) {
            return Constantes.INFINI;
        }
        double h = Math.sqrt(h2);
        double c = fx * fx + fy * fy + fz * fz - r * r;
        if (c > 0) {
            return b > 0 ? c / (b + h) : Constantes.INFINI;
        }
        if (b > 0) {
            return b + h;
        }
        return c < 0 ? c / (b - h) : Constantes.INFINI;
    }

    /**
     * {@inheritDoc} Au centre même (une sphère plus petite que ce que ses coordonnées distinguent), c'est par convention
     * (0, 0, −1).
     */
    @Override
    public Vecteur getNormale(Point contact) {
        Vecteur n = new Vecteur(centre, contact);
        return n.x == 0 && n.y == 0 && n.z == 0 ? VERS_L_OEIL : n.normalized();
    }

    @Override
    public String toString() {
        return "Sphere(" + centre + ", " + rayon + ")";
    }
}
