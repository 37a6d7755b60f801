package lancer;

import lancer.precision.Doute;
import lancer.precision.IntersectionCompensee;
import lancer.precision.Norme;

/** Une sphère (cours, « Intersection de rayons et de sphères »). Sa géométrie est immuable. */
public class Sphere extends Objet3D {

    /** La normale convenue au centre même : vers l'œil. */
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

    /** Le demi-diamètre, en unités de la scène. */
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
     * La plus petite distance strictement positive de P à la sphère le long de V, de longueur 1 : +∞ s'il n'y en a
     * pas ; une tangente est un contact ; de l'intérieur, c'est la sortie ; NaN ne touche rien.
     *
     * <p>Avec f = C − P et b = f·V, la demi-corde est h = √(r² − |f − bV|²) : le discriminant pris sur la
     * perpendiculaire ne soustrait pas deux grands carrés, et reste juste pour une sphère petite ou lointaine (Haines,
     * Günther et Akenine-Möller, <i>Precision Improvements for Ray/Sphere Intersection</i>, Ray Tracing Gems, 2019, ch.
     * 7). Les racines b − h et b + h ont pour produit c = |f|² − r² : celle qui soustrairait deux nombres voisins
     * s'obtient en divisant c par l'autre. Là où c même soustrait deux nombres voisins, P étant près de la surface,
     * {@link IntersectionCompensee} reprend le calcul.
     *
     * <p>Erreur relative : au plus 8 u (1 + r/h), u = 2⁻⁵³, arrondi de la direction compris, qui à lui seul en permet
     * presque autant (mesurée au pire, les trois quarts, près de la part où le doute commence). Toutes longueurs de
     * 1e-300 à 1e300.
     */
    public static double distance(double px, double py, double pz, double vx, double vy, double vz,
            double cx, double cy, double cz, double r) {
        double d = distanceOuDoute(px, py, pz, vx, vy, vz, cx, cy, cz, r);
        return d >= 0 ? d : trancher(px, py, pz, vx, vy, vz, cx, cy, cz, r);
    }

    /**
     * {@link #distance}, ou un nombre négatif si {@link #trancher} doit en décider ; cette distance n'est alors pas
     * inférieure à {@link Doute#auMoins} de ce nombre. À part pour qu'une boucle puisse trancher dehors.
     */
    public static double distanceOuDoute(double px, double py, double pz, double vx, double vy, double vz,
            double cx, double cy, double cz, double r) {
        double fx = cx - px;
        double fy = cy - py;
        double fz = cz - pz;
        double b = fx * vx + fy * vy + fz * vz;
        double lx = fx - b * vx;
        double ly = fy - b * vy;
        double lz = fz - b * vz;
        double l2 = lx * lx + ly * ly + lz * lz;
        double r2 = r * r;
        // écrit ainsi, NaN veut dire « rien » lui aussi
        if (!(l2 <= r2 * Doute.A_COTE + Norme.CARRE_MIN)) {
            return Constantes.INFINI;
        }
        double f2 = fx * fx + fy * fy + fz * fz;
        double c = f2 - r2;
        if (!(r2 > Norme.CARRE_MIN && Math.abs(c) < Norme.CARRE_MAX)) {
            return Doute.ENTIER;
        }
        double h2 = r2 - l2;
        if (c > Doute.SUR * f2) {
            return b > 0 && h2 >= 0 ? c / (b + Math.sqrt(h2)) : Constantes.INFINI;
        }
        if (c > Doute.APPROCHE * f2) {
            return b <= 0 ? Constantes.INFINI : h2 >= 0 ? -c / (b + Math.sqrt(h2)) : Doute.ENTIER;
        }
        if (c < -Doute.SUR * f2) {
            double h = Math.sqrt(h2);
            return b > 0 ? b + h : c / (b - h);
        }
        return Doute.ENTIER;
    }

    /** La distance, là où {@link #distanceOuDoute} est en doute. */
    public static double trancher(double px, double py, double pz, double vx, double vy, double vz,
            double cx, double cy, double cz, double r) {
        double fx = cx - px;
        double fy = cy - py;
        double fz = cz - pz;
        double s = Norme.echelle(fx, fy, fz, r);
        if (s == 1) {
            return IntersectionCompensee.distance(px, py, pz, vx, vy, vz, cx, cy, cz, r);
        }
        // tout multiplié par s, depuis un départ et un centre qui ont cette même différence
        return distance(-s * IntersectionCompensee.reste(cx, -px, fx), -s * IntersectionCompensee.reste(cy, -py, fy),
                -s * IntersectionCompensee.reste(cz, -pz, fz), vx, vy, vz, s * fx, s * fy, s * fz, s * r) / s;
    }

    /**
     * {@inheritDoc} C'est C + r·(X − C)/|X − C|, écrit X − e·(X − C) : à u près de chaque coordonnée, à moins de 4 u (r
     * + |C|) de la surface, d'où que vienne le rayon (un contact calculé de loin, X = P + tV, en est à 2 u |X − P| ;
     * idée de Pharr, Jakob et Humphreys, <i>Physically Based Rendering</i>, 4e éd., § 6.8). Le centre, et ce qui n'est
     * pas fini, restent où ils sont.
     */
    @Override
    public Point getPointDeSurface(Point contact) {
        Vecteur n = new Vecteur(centre, contact);
        double carre = n.norme2();
        if (carre >= Norme.CARRE_MIN && carre <= Norme.CARRE_MAX) {
            return contact.add(-Norme.ecart(carre, rayon), n);
        }
        return pointExtreme(n, contact);
    }

    private Point pointExtreme(Vecteur n, Point contact) {
        double norme = n.norme();
        return norme > 0 && norme <= Double.MAX_VALUE ? centre.add(n.normalized().mul(rayon)) : contact;
    }

    /**
     * {@inheritDoc} Au centre même (une sphère plus petite que ce que ses coordonnées distinguent), c'est par
     * convention (0, 0, −1).
     */
    @Override
    public Vecteur getNormale(Point contact) {
        double parRayon = 1 / rayon;
        Vecteur n = new Vecteur((contact.x - centre.x) * parRayon, (contact.y - centre.y) * parRayon,
                (contact.z - centre.z) * parRayon);
        return Math.abs(n.norme2() - 1) <= Norme.PRESQUE_UN ? n.normalized()
                : normaleExtreme(new Vecteur(centre, contact));
    }

    private static Vecteur normaleExtreme(Vecteur n) {
        return n.x == 0 && n.y == 0 && n.z == 0 ? VERS_L_OEIL : n.normalized();
    }

    @Override
    public String toString() {
        return "Sphere(" + centre + ", " + rayon + ")";
    }
}
