package lancer;

/**
 * Une couleur par ses composantes rouge, verte et bleue. Pendant le calcul, les composantes ne sont pas limitées à [0,
 * 1], car les lumières de plusieurs lampes s'ajoutent. Seule {@link #getCode()} les limite. Immuable.
 */
public final class Couleur {

    public final double r;
    public final double v;
    public final double b;

    public Couleur() {
        this(0);
    }

    /** Le gris de niveau {@code g} : 0 noir, 1 blanc. */
    public Couleur(double g) {
        this(g, g, g);
    }

    public Couleur(double r, double v, double b) {
        this.r = r;
        this.v = v;
        this.b = b;
    }

    public Couleur add(Couleur c) {
        return new Couleur(r + c.r, v + c.v, b + c.b);
    }

    public Couleur sub(Couleur c) {
        return new Couleur(r - c.r, v - c.v, b - c.b);
    }

    public Couleur mul(double k) {
        return new Couleur(r * k, v * k, b * k);
    }

    /** Produit composante par composante : la lumière que renvoie une surface de couleur {@code c}. */
    public Couleur mul(Couleur c) {
        return new Couleur(r * c.r, v * c.v, b * c.b);
    }

    public Couleur div(double k) {
        return new Couleur(r / k, v / k, b / k);
    }

    public boolean estNoire() {
        return r == 0 && v == 0 && b == 0;
    }

    /** Dit si les trois composantes sont des nombres finis. */
    public boolean estFinie() {
        // ∞ − ∞ et NaN − NaN valent NaN
        return r - r == 0 && v - v == 0 && b - b == 0;
    }

    public double max() {
        return Math.max(r, Math.max(v, b));
    }

    /**
     * Le code 0xFFRRGGBB de la couleur, pour l'écran. Chaque composante est limitée à [0, 1], puis arrondie au plus
     * proche de 0..255 (la moitié vers le haut) ; NaN donne 0.
     */
    public int getCode() {
        return 0xFF000000 | octet(r) << 16 | octet(v) << 8 | octet(b);
    }

    private static int octet(double composante) {
        return (int) (255 * Math.max(0, Math.min(1, composante)) + 0.5);
    }

    public static Couleur add(Couleur c, Couleur d) {
        return c.add(d);
    }

    public static Couleur sub(Couleur c, Couleur d) {
        return c.sub(d);
    }

    public static Couleur mul(Couleur c, double k) {
        return c.mul(k);
    }

    public static Couleur mul(Couleur c, Couleur d) {
        return c.mul(d);
    }

    public static Couleur div(Couleur c, double k) {
        return c.div(k);
    }

    /** Égalité stricte, comme {@link Tuple#equals}. */
    @Override
    public boolean equals(Object autre) {
        if (!(autre instanceof Couleur)) {
            return false;
        }
        Couleur c = (Couleur) autre;
        return Double.compare(r, c.r) == 0 && Double.compare(v, c.v) == 0 && Double.compare(b, c.b) == 0;
    }

    @Override
    public int hashCode() {
        return 31 * (31 * Double.hashCode(r) + Double.hashCode(v)) + Double.hashCode(b);
    }

    /** Texte de la forme {@code Couleur(0.9, 0.15, 0.1)}. */
    @Override
    public String toString() {
        return "Couleur(" + r + ", " + v + ", " + b + ")";
    }
}
