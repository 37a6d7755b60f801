package lancer;

import lancer.precision.IntersectionCompensee;

/** Une sphère (cours, « Intersection de rayons et de sphères »). Sa géométrie est immuable. */
public class Sphere extends Objet3D {

    /** La normale convenue au centre même : vers l'œil. */
    private static final Vecteur VERS_L_OEIL = new Vecteur(0, 0, -1);

    /** Ce que {@link #distanceOuDoute} répond, en doute, quand elle n'a pas même une approximation. */
    private static final double DOUTE = -Double.MIN_VALUE;

    /**
     * Part de |C − P|² que c doit dépasser pour que la forme directe suffise : l'erreur de c est d'au plus 6 u |C −
     * P|², donc celle de la distance de 24 u au plus, pour 16 u au moins de tolérance. Mesurée sur 10⁵ tirages serrés
     * autour de cette part : 12 u.
     */
    private static final double SUR = 0.25;

    /**
     * Part de |C − P|² au-dessus de laquelle le signe de c est certain, et la distance directe juste à un dix-millième
     * près.
     */
    private static final double APPROCHE = 0x1p-20;

    /**
     * Carré de la distance à l'axe, en parts de r², au-delà duquel le rayon passe à côté, quoi qu'aient fait les
     * arrondis.
     */
    private static final double A_COTE = 1 + 0x1p-49;

    /** Un écart relatif dont le carré est sous la moitié de u. */
    private static final double ECART_PETIT = 0x1p-28;

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
        return d >= 0 ? d : IntersectionCompensee.distance(px, py, pz, vx, vy, vz, cx, cy, cz, r);
    }

    /**
     * {@link #distance}, ou un nombre négatif si {@link IntersectionCompensee#distance} doit en décider ; cette
     * distance n'est alors pas inférieure à {@link #auMoins} de ce nombre. À part pour qu'une boucle puisse trancher
     * dehors.
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
        if (!(l2 <= r2 * A_COTE + Vecteur.NORME2_MIN)) {
            return Constantes.INFINI;
        }
        double f2 = fx * fx + fy * fy + fz * fz;
        double c = f2 - r2;
        if (!(r2 > Vecteur.NORME2_MIN && Math.abs(c) < Vecteur.NORME2_MAX)) {
            return DOUTE;
        }
        double h2 = r2 - l2;
        if (c > SUR * f2) {
            return b > 0 && h2 >= 0 ? c / (b + Math.sqrt(h2)) : Constantes.INFINI;
        }
        if (c > APPROCHE * f2) {
            return b <= 0 ? Constantes.INFINI : h2 >= 0 ? -c / (b + Math.sqrt(h2)) : DOUTE;
        }
        if (c < -SUR * f2) {
            double h = Math.sqrt(h2);
            return b > 0 ? b + h : c / (b - h);
        }
        return DOUTE;
    }

    /**
     * Une distance que la vraie, quelle qu'elle soit, atteint ou dépasse.
     *
     * @param doute réponse négative de {@link #distanceOuDoute}
     */
    public static double auMoins(double doute) {
        return -0.9999 * doute;
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
        if (carre >= Vecteur.NORME2_MIN && carre <= Vecteur.NORME2_MAX) {
            return contact.add(-ecart(carre, rayon), n);
        }
        return pointExtreme(n, contact);
    }

    private Point pointExtreme(Vecteur n, Point contact) {
        double norme = n.norme();
        return norme > 0 && norme <= Double.MAX_VALUE ? centre.add(n.normalized().mul(rayon)) : contact;
    }

    /**
     * De quelle part d'elle-même la longueur √carre dépasse r : 1 − r/√carre.
     *
     * @param carre ordinaire ({@link Vecteur#NORME2_MIN}, {@link Vecteur#NORME2_MAX})
     */
    public static double ecart(double carre, double r) {
        double r2 = r * r;
        double e = (carre - r2) * (0.5 / r2);
        // le carré de e ne compte pas : d'ordinaire, ni racine, ni division qui attende
        return Math.abs(e) < ECART_PETIT ? e : 1 - r / Math.sqrt(carre);
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
        return Math.abs(n.norme2() - 1) <= Vecteur.PRESQUE_UN ? n.normalized()
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
