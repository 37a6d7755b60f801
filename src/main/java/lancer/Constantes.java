package lancer;

/** Toutes les constantes du programme, chacune avec son unité et sa raison. */
public final class Constantes {

    /** Largeur de l'écran, en unités de la scène (cours, « Écran, œil et projection »). */
    public static final double ECHELLE = 2;

    /** Angle sous lequel l'œil voit la largeur de l'écran, en degrés (cours, même section). */
    public static final double CHAMP = 30;

    /** Largeur d'une image dont la taille n'est pas demandée, en pixels. */
    public static final int LARGEUR_IMAGE = 800;

    /** Hauteur d'une image dont la taille n'est pas demandée, en pixels. */
    public static final int HAUTEUR_IMAGE = 600;

    /** Nombre de réflexions successives d'un rayon, si rien d'autre n'est demandé (cours, « Reflets »). */
    public static final int MAX_REFLETS = 5;

    /**
     * Seuil sous lequel un reflet n'est plus suivi : le quart d'un des 256 niveaux de l'écran, sur la plus grande
     * composante du produit des Ks rencontrés (cours, « Reflets », dernier paragraphe).
     */
    public static final double SEUIL = 1.0 / 1024;

    /** Côté d'un carré du brouillon, en pixels : 16 fois moins de rayons que l'image. */
    public static final int PAS_BROUILLON = 4;

    /** Nombre de réflexions au plus dans le brouillon. */
    public static final int REFLETS_BROUILLON = 1;

    /**
     * Rapport de la plus grande coordonnée d'une lampe à celle d'un contact, au-delà duquel elle en est lointaine. Un
     * rayon qui en part manque le contact de 2^-40 fois la coordonnée de celui-ci, ou plus. Dans les scènes livrées, il
     * ne passe pas 183 : un contact plus près de l'origine garde des lampes proches ({@link Scene#estCachee}).
     */
    public static final double LOINTAINE = 8192;

    /** Distance d'un contact qui n'existe pas. */
    public static final double INFINI = Double.POSITIVE_INFINITY;

    /** Le ciel à l'horizon ; plus haut, il va vers le bleu pur (cours, « Ciel »). */
    public static final Couleur CIEL = new Couleur(0.7, 0.7, 1);

    /** Le sol à l'horizon, et ce que son vert perd jusque droit au-dessous. */
    public static final Couleur SOL = new Couleur(0.5, 0.4, 0.1);
    public static final double SOL_ASSOMBRI = 0.2;

    private Constantes() {
    }
}
