package lancer.rapide;

/** Une boîte qui contient des sphères entières, et la marge que demandent les arrondis de tout ce qui s'y passe. */
final class Etendue {

    /**
     * Marge des boîtes, en part de la plus grande coordonnée. La distance calculée par {@link lancer.Sphere#distance}
     * est celle d'une sphère dont le rayon diffère d'au plus 16 u (|C − P| + r), u = 2^-53 ; le calcul d'une boîte
     * ajoute 4 u fois les coordonnées. 2^-36 les couvre encore quand le rayon part de {@link #DEPART_MAX} fois plus
     * loin que la boîte.
     */
    private static final double MARGE_RELATIVE = 0x1.0p-36;

    /** Un rayon qui part de plus loin que cela, en portées de la boîte, a des arrondis que la marge ne couvre plus. */
    static final double DEPART_MAX = 2048;

    /** Au-delà, ou en deçà, une boîte de flottants n'a plus de sens. */
    static final double LONGUEUR_MAX = 1e30;
    static final double LONGUEUR_MIN = 1e-30;

    double xMin = Double.POSITIVE_INFINITY;
    double yMin = Double.POSITIVE_INFINITY;
    double zMin = Double.POSITIVE_INFINITY;
    double xMax = Double.NEGATIVE_INFINITY;
    double yMax = Double.NEGATIVE_INFINITY;
    double zMax = Double.NEGATIVE_INFINITY;

    void ajouter(double x, double y, double z, double r) {
        xMin = Math.min(xMin, x - r);
        yMin = Math.min(yMin, y - r);
        zMin = Math.min(zMin, z - r);
        xMax = Math.max(xMax, x + r);
        yMax = Math.max(yMax, y + r);
        zMax = Math.max(zMax, z + r);
    }

    /** @param autre {@code null} si elle est vide */
    void ajouter(Etendue autre) {
        if (autre != null) {
            xMin = Math.min(xMin, autre.xMin);
            yMin = Math.min(yMin, autre.yMin);
            zMin = Math.min(zMin, autre.zMin);
            xMax = Math.max(xMax, autre.xMax);
            yMax = Math.max(yMax, autre.yMax);
            zMax = Math.max(zMax, autre.zMax);
        }
    }

    /** La moitié de l'aire de la boîte. */
    double aire() {
        double a = xMax - xMin;
        double b = yMax - yMin;
        double c = zMax - zMin;
        return a * b + b * c + c * a;
    }

    /** La boîte de ces sphères. */
    static Etendue de(Spheres spheres, int[] lesquelles) {
        Etendue e = new Etendue();
        double[] g = spheres.geometrie;
        for (int k : lesquelles) {
            int s = Spheres.PAS * k;
            e.ajouter(g[s], g[s + 1], g[s + 2], g[s + 3]);
        }
        return e;
    }

    /** La plus grande coordonnée, en valeur absolue. */
    double portee() {
        return Math.max(Math.max(Math.max(-xMin, xMax), Math.max(-yMin, yMax)), Math.max(-zMin, zMax));
    }

    /** L'élargissement d'une boîte de cette portée. */
    static double marge(double portee) {
        return MARGE_RELATIVE * portee;
    }

    /** Le flottant juste au-dessous, ou égal. */
    static float enBas(double x) {
        float f = (float) x;
        return f <= x ? f : Math.nextDown(f);
    }

    /** Le flottant juste au-dessus, ou égal. */
    static float enHaut(double x) {
        float f = (float) x;
        return f >= x ? f : Math.nextUp(f);
    }
}
