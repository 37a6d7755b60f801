package lancer.precision;

/** Les longueurs : là où leur carré est un nombre ordinaire, et là où il ne l'est pas. */
public final class Norme {

    /** Carrés de norme entre lesquels ceux des composantes ne perdent pas de chiffres (2^-1022), ni ne débordent. */
    public static final double CARRE_MIN = 0x1.0p-900;
    public static final double CARRE_MAX = 0x1.0p1000;

    /** Écart à 1 sous lequel le carré c d'une longueur donne 1/√c = 1,5 − 0,5 c, au carré de cet écart près. */
    public static final double PRESQUE_UN = 0x1p-27;

    /** Un rayon plus petit que cette part de la distance au centre n'y compte plus. */
    private static final double POUSSIERE = 0x1p-449;

    /** Un écart relatif dont le carré est sous la moitié de u. */
    private static final double ECART_PETIT = 0x1p-28;

    private Norme() {
    }

    /** Dit si ni le carré de ce rayon, ni sa somme avec celui de ce vecteur, ne perdent de chiffres. */
    public static boolean sontOrdinaires(double x, double y, double z, double rayon) {
        double r2 = rayon * rayon;
        return r2 > CARRE_MIN && r2 + (x * x + y * y + z * z) < CARRE_MAX;
    }

    /** La puissance de deux qui, par une multiplication, les rend ordinaires ; 1 s'ils le sont, ou si rien n'y fait. */
    public static double echelle(double x, double y, double z, double rayon) {
        if (sontOrdinaires(x, y, z, rayon)) {
            return 1;
        }
        double max = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.max(Math.abs(z), rayon));
        double echelle = Math.scalb(1.0, -Math.getExponent(max));
        return max <= Double.MAX_VALUE && echelle * rayon >= POUSSIERE ? echelle : 1;
    }

    /** Part d'elle-même dont la longueur √carre, ordinaire ({@link #CARRE_MIN}), dépasse r : 1 − r/√carre. */
    public static double ecart(double carre, double r) {
        double r2 = r * r;
        double e = (carre - r2) * (0.5 / r2);
        // le carré de e ne compte pas : d'ordinaire, ni racine, ni division qui attende
        return Math.abs(e) < ECART_PETIT ? e : 1 - r / Math.sqrt(carre);
    }
}
