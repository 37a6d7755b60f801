package lancer.precision;

/** Longueurs ordinaires, dont le carré ne déborde pas et ne perd pas de chiffres, et autres longueurs. */
public final class Norme {

    /** Carrés de norme entre lesquels les carrés des composantes ne perdent pas de chiffres et ne débordent pas. */
    public static final double CARRE_MIN = 0x1.0p-900;
    public static final double CARRE_MAX = 0x1.0p1000;

    /** Plus grand écart de 1 au carré c d'une longueur pour que 1/√c = 1,5 − 0,5 c, au carré de l'écart près. */
    public static final double PRESQUE_UN = 0x1p-27;

    /** Écart relatif dont le carré est inférieur à u/2. */
    private static final double ECART_PETIT = 0x1p-28;

    private Norme() {
    }

    /** Dit si le carré de ce rayon, et sa somme avec celui de ce vecteur, ne perdent pas de chiffres. */
    public static boolean sontOrdinaires(double x, double y, double z, double rayon) {
        double r2 = rayon * rayon;
        return r2 > CARRE_MIN && r2 + (x * x + y * y + z * z) < CARRE_MAX;
    }

    /** Puissance de deux dont le produit par ces longueurs est ordinaire ; 1 si elle est inutile ou impossible. */
    public static double echelle(double x, double y, double z, double rayon) {
        if (sontOrdinaires(x, y, z, rayon)) {
            return 1;
        }
        double max = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.max(Math.abs(z), rayon));
        double echelle = Math.scalb(1.0, -Math.getExponent(max));
        return sontOrdinaires(echelle * x, echelle * y, echelle * z, echelle * rayon) ? echelle : 1;
    }

    /** Écart relatif 1 − r/√carre entre r et la longueur √carre, ordinaire ({@link #CARRE_MIN}). */
    public static double ecart(double carre, double r) {
        double r2 = r * r;
        double e = (carre - r2) * (0.5 / r2);
        // le carré de e est presque toujours négligeable : cela évite une racine et une deuxième division
        return Math.abs(e) < ECART_PETIT ? e : 1 - r / Math.sqrt(carre);
    }
}
