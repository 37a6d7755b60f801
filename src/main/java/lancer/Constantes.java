package lancer;

/** Les constantes du cours, chacune avec son unité et sa source. */
public final class Constantes {

    /** Largeur de l'écran, en unités de la scène (cours, « Écran, œil et projection »). */
    public static final double ECHELLE = 2;

    /** Angle sous lequel l'œil voit la largeur de l'écran, en degrés (cours, même section). */
    public static final double CHAMP = 30;

    /** Largeur de l'image, en pixels, si aucune taille n'est demandée. */
    public static final int LARGEUR_IMAGE = 800;

    /** Hauteur de l'image, en pixels, si aucune taille n'est demandée. */
    public static final int HAUTEUR_IMAGE = 600;

    /** Nombre de réflexions successives d'un rayon, si aucun n'est demandé (cours, « Reflets »). */
    public static final int MAX_REFLETS = 5;

    /**
     * Un rayon réfléchi est lancé si la plus grande composante du produit des Ks rencontrés atteint ce seuil. Sa valeur
     * est le quart d'un des 256 niveaux de l'écran (cours, « Reflets », dernier paragraphe).
     */
    public static final double SEUIL = 1.0 / 1024;

    /** Côté d'un carré du brouillon, en pixels : le brouillon lance 16 fois moins de rayons que l'image. */
    public static final int PAS_BROUILLON = 4;

    /** Nombre maximal de réflexions dans le brouillon. */
    public static final int REFLETS_BROUILLON = 1;

    /**
     * Une lampe est lointaine si sa plus grande coordonnée dépasse {@code LOINTAINE} fois celle du contact. Un rayon
     * d'ombre qui part de cette lampe manque le contact d'au moins 2^-40 fois la coordonnée du contact. Dans les scènes
     * livrées, ce rapport ne dépasse pas 183 ({@link Scene#estCachee}).
     */
    public static final double LOINTAINE = 8192;

    /** Distance d'un contact qui n'existe pas. */
    public static final double INFINI = Double.POSITIVE_INFINITY;

    /** Couleur du ciel à l'horizon ; vers le zénith, elle tend vers le bleu pur (cours, « Ciel »). */
    public static final Couleur CIEL = new Couleur(0.7, 0.7, 1);

    /** Couleur du sol à l'horizon, puis baisse de sa composante verte de l'horizon à la verticale. */
    public static final Couleur SOL = new Couleur(0.5, 0.4, 0.1);
    public static final double SOL_ASSOMBRI = 0.2;

    private Constantes() {
    }
}
