package lancer;

/** Les constantes du programme. */
public final class Constantes {

    /** Largeur de l'écran, en unités de la scène. */
    public static final double ECHELLE = 2;

    /** Angle sous lequel l'œil voit la largeur de l'écran, en degrés. */
    public static final double CHAMP = 30;

    /** Taille de l'image, en pixels. */
    public static final int LARGEUR_IMAGE = 800;
    public static final int HAUTEUR_IMAGE = 600;

    /** Nombre de reflets successifs d'un rayon. */
    public static final int MAX_REFLETS = 5;

    /** Distance d'un contact qui n'existe pas. */
    public static final double INFINI = Double.POSITIVE_INFINITY;

    private Constantes() {
    }
}
