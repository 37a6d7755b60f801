package lancer.precision;

import lancer.Constantes;

/**
 * L'intersection d'un rayon et d'une sphère quand {@link Intersection#distance} serait fausse. Le rayon part près de la
 * surface (un sol immense, une sphère qui en touche une autre), ou un carré déborde.
 *
 * <p>Seule la puissance de P, c = |C − P|² − r², perd ses chiffres. Elle est calculée ici presque sans erreur. C − P
 * est gardé en deux termes, avec f + e = C − P exactement (Knuth, <i>The Art of Computer Programming</i>, t. 2, §
 * 4.2.2). Les longueurs sont coupées en morceaux dont les produits et les sommes sont exacts (Dekker, <i>A
 * floating-point technique for extending the available precision</i>, Numerische Mathematik 18, 1971). La coupe commune
 * est celle de Rump, Ogita et Oishi (<i>Accurate floating-point summation</i>, SIAM Journal on Scientific Computing 31,
 * 2008). Enfin, h² = b² − c. Près de la surface, cette forme n'amplifie pas l'arrondi de la direction.
 *
 * <p>Erreur relative de la distance : au plus 8 u (1 + r/h), avec u = 2⁻⁵³, arrondi de la direction compris. L'erreur
 * mesurée est inférieure à la moitié de cette borne. Aucun objet n'est alloué.
 */
public final class IntersectionCompensee {

    /** Si la puissance calculée d'abord dépasse cette part de r², elle est juste à u près. */
    private static final double ASSEZ = 0x1p-20;

    /** Largeurs des morceaux, en parts de r : ajouter 1,5 · 2^k arrondit un nombre à un multiple de 2^(k−52). */
    private static final double COUPE = 0x1.8p27;
    private static final double COUPE_DU_RESTE = 0x1.8p1;
    private static final double COUPE_DE_L_ERREUR = 0x1.8p-25;

    /** Si h² est négatif de moins que cette part de b·r, la perpendiculaire décide si le rayon est tangent. */
    private static final double TANGENTE = 0x1p-49;

    private static final long EXPOSANT = 0x7ff0000000000000L;

    private IntersectionCompensee() {
    }

    /** La distance d'{@link Intersection#distance}, quand sa forme directe a un doute. */
    public static double distance(double px, double py, double pz, double vx, double vy, double vz,
            double cx, double cy, double cz, double r) {
        double fx = cx - px;
        double fy = cy - py;
        double fz = cz - pz;
        double b = fx * vx + fy * vy + fz * vz;
        if (!Norme.sontOrdinaires(fx, fy, fz, r)) {
            // la sphère est si petite qu'elle compte pour un point
            return b > 0 && Math.hypot(Math.hypot(fx - b * vx, fy - b * vy), fz - b * vz) <= r ? b : Constantes.INFINI;
        }
        double c = puissance(fx, fy, fz, reste(cx, -px, fx), reste(cy, -py, fy), reste(cz, -pz, fz), r);
        double h2 = b * b - c;
        if (c > 0 && b > 0 && h2 < 0) {
            // un arrondi peut rendre h² négatif pour une tangente : la perpendiculaire est exacte sur des nombres ronds
            double lx = fx - b * vx;
            double ly = fy - b * vy;
            double lz = fz - b * vz;
            return h2 >= -TANGENTE * b * r && lx * lx + ly * ly + lz * lz <= r * r ? c / b : Constantes.INFINI;
        }
        if (c > 0) {
            return b > 0 ? c / (b + Math.sqrt(h2)) : Constantes.INFINI;
        }
        double h = Math.sqrt(h2);
        if (b > 0) {
            return b + h;
        }
        return c < 0 ? c / (b - h) : Constantes.INFINI;
    }

    /** Erreur d'arrondi de {@code somme} = a + b, exacte. */
    public static double reste(double a, double b, double somme) {
        double t = somme - a;
        return (a - (somme - t)) + (b - t);
    }

    /**
     * Puissance |f + e|² − r², à 2⁻⁵³ près en valeur relative, ou à 2⁻¹²⁷ r² près si cette valeur est plus grande.
     * Chaque longueur x est la somme h + d, où h est multiple d'un même pas : les carrés des h et leur somme sont
     * exacts. Alors x² = h² + 2hd + d².
     */
    static double puissance(double fx, double fy, double fz, double ex, double ey, double ez, double r) {
        double pas = Double.longBitsToDouble(Double.doubleToRawLongBits(r) & EXPOSANT);
        double coupe = COUPE * pas;
        double hx = fx + coupe - coupe;
        double hy = fy + coupe - coupe;
        double hz = fz + coupe - coupe;
        double hr = r + coupe - coupe;
        double dx = fx - hx;
        double dy = fy - hy;
        double dz = fz - hz;
        double dr = r - hr;
        double haut = hx * hx + hy * hy + hz * hz - hr * hr;
        double bas = dx * (fx + hx) + dy * (fy + hy) + dz * (fz + hz) - dr * (r + hr);
        double c = haut + (bas + 2 * (fx * ex + fy * ey + fz * ez));
        return Math.abs(c) > ASSEZ * (r * r) ? c : finement(haut, pas, hx, hy, hz, hr, dx, dy, dz, dr, ex, ey, ez);
    }

    /** Puissance très proche de zéro : d et e sont coupés aussi, et seule une part sous 2⁻⁷⁶ r² est arrondie. */
    private static double finement(double haut, double pas, double hx, double hy, double hz, double hr,
            double dx, double dy, double dz, double dr, double ex, double ey, double ez) {
        double coupeD = COUPE_DU_RESTE * pas;
        double gx = dx + coupeD - coupeD;
        double gy = dy + coupeD - coupeD;
        double gz = dz + coupeD - coupeD;
        double gr = dr + coupeD - coupeD;
        double coupeE = COUPE_DE_L_ERREUR * pas;
        double ix = ex + coupeE - coupeE;
        double iy = ey + coupeE - coupeE;
        double iz = ez + coupeE - coupeE;
        double carres = gx * gx + gy * gy + gz * gz - gr * gr + 2 * (hx * ix + hy * iy + hz * iz);
        double poussiere = (dx - gx) * (dx + gx) + (dy - gy) * (dy + gy) + (dz - gz) * (dz + gz) - (dr - gr) * (dr + gr)
                + 2 * (hx * (ex - ix) + hy * (ey - iy) + hz * (ez - iz) + (dx * ex + dy * ey + dz * ez))
                + (ex * ex + ey * ey + ez * ez);
        double x = 2 * hx * dx;
        double y = 2 * hy * dy;
        double z = 2 * hz * dz;
        double w = -2 * hr * dr;
        double s1 = haut + x;
        double s2 = s1 + y;
        double s3 = s2 + z;
        double s4 = s3 + w;
        double s5 = s4 + carres;
        return s5 + (reste(haut, x, s1) + reste(s1, y, s2) + reste(s2, z, s3) + reste(s3, w, s4) + reste(s4, carres, s5)
                + poussiere);
    }
}
