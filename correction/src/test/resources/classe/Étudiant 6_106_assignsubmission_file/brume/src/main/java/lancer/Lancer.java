package lancer;

/** L'algorithme : de la scène à l'image (cours, « Algorithme général »). */
public class Lancer {

    private static final int PAS_BROUILLON = 4;

    private final Scene scene;
    private final Camera camera;

    public Lancer(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
    }

    /**
     * La couleur vue à travers un point de l'écran.
     *
     * @param xe en pixels depuis la gauche
     * @param ye en pixels depuis le haut
     * @param profondeur le nombre de reflets permis
     */
    public Couleur getCouleurPixel(double xe, double ye, int profondeur) {
        Rayon initial = camera.getRayon(xe, ye);
        PointContact contact = scene.getClosestIntersection(initial);
        if (contact == null) {
            return Brume.COULEUR;
        }
        return Brume.voiler(contact.objet.getColor(scene, initial, contact, profondeur), contact.distance);
    }

    /** Dessine un brouillon, un rayon pour 4 x 4 pixels, puis chaque pixel, au centre duquel passe un rayon. */
    public void TracerImage(Toile toile, int largeur, int hauteur, int profondeur) {
        for (int ye = 0; ye < hauteur; ye += PAS_BROUILLON) {
            for (int xe = 0; xe < largeur; xe += PAS_BROUILLON) {
                Couleur couleur = getCouleurPixel(xe + PAS_BROUILLON / 2.0, ye + PAS_BROUILLON / 2.0, Math.min(1, profondeur));
                for (int y = ye; y < Math.min(hauteur, ye + PAS_BROUILLON); y++) {
                    for (int x = xe; x < Math.min(largeur, xe + PAS_BROUILLON); x++) {
                        toile.drawPixel(couleur, x, y);
                    }
                }
            }
        }
        for (int ye = 0; ye < hauteur; ye++) {
            for (int xe = 0; xe < largeur; xe++) {
                toile.drawPixel(getCouleurPixel(xe + 0.5, ye + 0.5, profondeur), xe, ye);
            }
            toile.avancer((ye + 1.0) / hauteur);
        }
    }
}
