package lancer.precision;

import lancer.Constantes;

/** L'intersection d'un rayon et d'une sphère, sur des nombres : la sphère et les recherches rapides l'utilisent. */
public final class Intersection {

    /** Carré de la distance à l'axe, en parts de r², au-delà duquel le rayon manque la sphère, arrondis compris. */
    private static final double A_COTE = 1 + 0x1p-49;

    /**
     * Si c dépasse cette part de |C − P|², la forme directe suffit. L'erreur de c est au plus 6 u |C − P|². Celle de la
     * distance est donc au plus 24 u ; la tolérance est d'au moins 16 u. Sur 10⁵ tirages proches, l'erreur est de 12 u.
     */
    private static final double SUR = 0.25;

    /** Si c dépasse cette part de |C − P|², son signe est certain, et la distance est juste à un dix-millième. */
    private static final double APPROCHE = 0x1p-20;

    private Intersection() {
    }

    /**
     * La plus petite distance strictement positive de P à la sphère le long de V, de longueur 1 ; +∞ s'il n'y en a pas.
     * Une tangente est un contact ; de l'intérieur, le contact est la sortie ; NaN ne touche rien.
     *
     * <p>Soit f = C − P et b = f·V : la demi-corde est h = √(r² − |f − bV|²). Ce discriminant, pris sur la
     * perpendiculaire, ne soustrait pas deux grands carrés : il reste juste pour une sphère petite ou lointaine
     * (Haines, Günther et Akenine-Möller, <i>Precision Improvements for Ray/Sphere Intersection</i>, Ray Tracing Gems,
     * 2019, ch. 7). Le produit des racines b − h et b + h est c = |f|² − r². La racine qui soustrairait deux nombres
     * voisins est donc calculée en divisant c par l'autre. Si P est près de la surface, c lui-même soustrait deux
     * nombres voisins, et {@link IntersectionCompensee} refait le calcul.
     *
     * <p>Erreur relative : au plus 8 u (1 + r/h), avec u = 2⁻⁵³, pour des longueurs de 1e-300 à 1e300. Cette borne
     * comprend l'arrondi de la direction, parfois presque toute l'erreur. L'erreur mesurée est au plus 3/4 de la borne.
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
        double l2 = lx * lx + ly * ly + lz * lz;
        double r2 = r * r;
        // la négation donne aussi « aucun contact » pour NaN
        if (!(l2 <= r2 * A_COTE + Norme.CARRE_MIN)) {
            return Constantes.INFINI;
        }
        double f2 = fx * fx + fy * fy + fz * fz;
        double c = f2 - r2;
        if (!(r2 > Norme.CARRE_MIN && Math.abs(c) < Norme.CARRE_MAX)) {
            return trancher(px, py, pz, vx, vy, vz, cx, cy, cz, r);
        }
        double h2 = r2 - l2;
        if (c > SUR * f2) {
            return b > 0 && h2 >= 0 ? c / (b + Math.sqrt(h2)) : Constantes.INFINI;
        }
        if (c > APPROCHE * f2 && b <= 0) {
            return Constantes.INFINI;
        }
        if (c < -SUR * f2) {
            double h = Math.sqrt(h2);
            return b > 0 ? b + h : c / (b - h);
        }
        return trancher(px, py, pz, vx, vy, vz, cx, cy, cz, r);
    }

    /** La distance quand la forme directe est en doute. */
    private static double trancher(double px, double py, double pz, double vx, double vy, double vz,
            double cx, double cy, double cz, double r) {
        double fx = cx - px;
        double fy = cy - py;
        double fz = cz - pz;
        double s = Norme.echelle(fx, fy, fz, r);
        if (s == 1) {
            return IntersectionCompensee.distance(px, py, pz, vx, vy, vz, cx, cy, cz, r);
        }
        // tout est multiplié par s ; le départ et le centre gardent exactement la même différence
        return distance(-s * IntersectionCompensee.reste(cx, -px, fx), -s * IntersectionCompensee.reste(cy, -py, fy),
                -s * IntersectionCompensee.reste(cz, -pz, fz), vx, vy, vz, s * fx, s * fy, s * fz, s * r) / s;
    }
}
