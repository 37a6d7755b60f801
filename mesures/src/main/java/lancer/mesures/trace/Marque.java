package lancer.mesures.trace;

/** Un point mesuré, à préciser de proche en proche. */
public final class Marque {

    final double x;
    final double y;
    double xMin;
    double xMax;
    double yMin;
    double yMax;

    /** Ce qui est écrit à côté, vide si rien. */
    String etiquette = "";

    /** Faux pour un point qui ne vaut pas la peine : il est dessiné en creux. */
    boolean pleine = true;

    /** Vrai pour un réglage par défaut : il est cerclé. */
    boolean cerclee;

    private Marque(double x, double y) {
        this.x = x;
        this.y = y;
    }

    public static Marque en(double x, double y) {
        return new Marque(x, y).entreX(x, x).entreY(y, y);
    }

    /** Avec une barre horizontale. */
    public Marque entreX(double min, double max) {
        xMin = min;
        xMax = max;
        return this;
    }

    /** Avec une barre verticale. */
    public Marque entreY(double min, double max) {
        yMin = min;
        yMax = max;
        return this;
    }

    public Marque nommee(String texte) {
        etiquette = texte;
        return this;
    }

    public Marque creuse() {
        pleine = false;
        return this;
    }

    public Marque cerclee() {
        cerclee = true;
        return this;
    }
}
