package lancer.precision;

import lancer.Constantes;

/** L'intersection d'un rayon et d'une sphère, sur des nombres : la seule équation de la sphère et des recherches. */
public final class Intersection {

    /** La réponse en doute de qui n'a pas même une approximation. */
    private static final double ENTIER = -Double.MIN_VALUE;

    /** Carré de la distance à l'axe, en parts de r², au-delà duquel le rayon passe à côté, arrondis compris. */
    private static final double A_COTE = 1 + 0x1p-49;

    /**
     * Part de |C − P|² que c doit dépasser pour que la forme directe suffise : l'erreur de c est d'au plus 6 u |C −
     * P|², donc celle de la distance de 24 u au plus, pour 16 u au moins de tolérance. Mesurée sur 10⁵ tirages serrés
     * autour de cette part : 12 u.
     */
    private static final double SUR = 0.25;

    /** Part de |C − P|² au-dessus de laquelle le signe de c est certain, et la distance juste à un dix-millième. */
    private static final double APPROCHE = 0x1p-20;

    private Intersection() {
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

    /** Rend {@link #distance} ou, en doute, un négatif : {@link #trancher} en décide, {@link #auMoins} la minore. */
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
        if (!(l2 <= r2 * A_COTE + Norme.CARRE_MIN)) {
            return Constantes.INFINI;
        }
        double f2 = fx * fx + fy * fy + fz * fz;
        double c = f2 - r2;
        if (!(r2 > Norme.CARRE_MIN && Math.abs(c) < Norme.CARRE_MAX)) {
            return ENTIER;
        }
        double h2 = r2 - l2;
        if (c > SUR * f2) {
            return b > 0 && h2 >= 0 ? c / (b + Math.sqrt(h2)) : Constantes.INFINI;
        }
        if (c > APPROCHE * f2) {
            return b <= 0 ? Constantes.INFINI : h2 >= 0 ? -c / (b + Math.sqrt(h2)) : ENTIER;
        }
        if (c < -SUR * f2) {
            double h = Math.sqrt(h2);
            return b > 0 ? b + h : c / (b - h);
        }
        return ENTIER;
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

    /** Une distance que la vraie, quelle qu'elle soit, atteint ou dépasse, d'après la réponse en doute. */
    public static double auMoins(double doute) {
        return -0.9999 * doute;
    }
}
