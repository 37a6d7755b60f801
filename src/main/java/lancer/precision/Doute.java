package lancer.precision;

/** Jusqu'où la forme directe de l'intersection d'une sphère suffit : voir {@link lancer.Sphere#distanceOuDoute}. */
public final class Doute {

    /** La réponse en doute de qui n'a pas même une approximation. */
    public static final double ENTIER = -Double.MIN_VALUE;

    /**
     * Carré de la distance à l'axe, en parts de r², au-delà duquel le rayon passe à côté, quoi qu'aient fait les
     * arrondis.
     */
    public static final double A_COTE = 1 + 0x1p-49;

    /**
     * Part de |C − P|² que c doit dépasser pour que la forme directe suffise : l'erreur de c est d'au plus 6 u |C −
     * P|², donc celle de la distance de 24 u au plus, pour 16 u au moins de tolérance. Mesurée sur 10⁵ tirages serrés
     * autour de cette part : 12 u.
     */
    public static final double SUR = 0.25;

    /**
     * Part de |C − P|² au-dessus de laquelle le signe de c est certain, et la distance directe juste à un dix-millième
     * près.
     */
    public static final double APPROCHE = 0x1p-20;

    private Doute() {
    }

    /** Une distance que la vraie, quelle qu'elle soit, atteint ou dépasse, d'après la réponse en doute. */
    public static double auMoins(double doute) {
        return -0.9999 * doute;
    }
}
