package lancer;

/**
 * Un triplet de réels (x, y, z) : ce qu'un {@link Point} et un {@link Vecteur} ont en commun (cours, « Points et
 * vecteurs »). Immuable : toute opération rend une nouvelle instance.
 */
public class Tuple {

    public final double x;
    public final double y;
    public final double z;

    public Tuple() {
        this(0, 0, 0);
    }

    public Tuple(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    /** La plus grande composante, en valeur absolue. */
    public double plusGrande() {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    /** Égalité stricte : même classe et mêmes composantes au sens de {@link Double#compare} (0.0 et −0.0 diffèrent). */
    @Override
    public boolean equals(Object autre) {
        if (autre == null || autre.getClass() != getClass()) {
            return false;
        }
        Tuple t = (Tuple) autre;
        return Double.compare(x, t.x) == 0 && Double.compare(y, t.y) == 0 && Double.compare(z, t.z) == 0;
    }

    @Override
    public int hashCode() {
        return 31 * (31 * Double.hashCode(x) + Double.hashCode(y)) + Double.hashCode(z);
    }

    /** Texte de la forme {@code Vecteur(1.0, 0.0, -2.5)}. */
    @Override
    public String toString() {
        return getClass().getSimpleName() + "(" + x + ", " + y + ", " + z + ")";
    }
}
