package lancer.mesures.trace;

/** Un point mesuré. Immuable : chaque précision donne une marque de plus. */
public final class Marque {

    final double x;
    final double xMin;
    final double xMax;
    final double y;
    final double yMin;
    final double yMax;

    /** Ce qui est écrit à côté, vide si rien. */
    final String etiquette;

    /** Faux pour un point qui ne vaut pas la peine : il est dessiné en creux. */
    final boolean pleine;

    /** Vrai pour un réglage par défaut : il est cerclé. */
    final boolean cerclee;

    private Marque(double x, double xMin, double xMax, double y, double yMin, double yMax, String etiquette, boolean pleine,
            boolean cerclee) {
        this.x = x;
        this.xMin = xMin;
        this.xMax = xMax;
        this.y = y;
        this.yMin = yMin;
        this.yMax = yMax;
        this.etiquette = etiquette;
        this.pleine = pleine;
        this.cerclee = cerclee;
    }

    public static Marque en(double x, double y) {
        return new Marque(x, x, x, y, y, y, "", true, false);
    }

    /** Avec une barre horizontale. */
    public Marque entreX(double min, double max) {
        return new Marque(x, min, max, y, yMin, yMax, etiquette, pleine, cerclee);
    }

    /** Avec une barre verticale. */
    public Marque entreY(double min, double max) {
        return new Marque(x, xMin, xMax, y, min, max, etiquette, pleine, cerclee);
    }

    public Marque nommee(String texte) {
        return new Marque(x, xMin, xMax, y, yMin, yMax, texte, pleine, cerclee);
    }

    public Marque creuse() {
        return new Marque(x, xMin, xMax, y, yMin, yMax, etiquette, false, cerclee);
    }

    public Marque cerclee() {
        return new Marque(x, xMin, xMax, y, yMin, yMax, etiquette, pleine, true);
    }
}
