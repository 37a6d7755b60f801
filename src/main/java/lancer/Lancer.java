package lancer;

import lancer.contrat.Boucle;
import lancer.contrat.Toile;

/** L'algorithme : de la scène à l'image (cours, « Algorithme général »). */
public final class Lancer {

    private final Scene scene;
    private final Camera camera;

    public Lancer(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
    }

    public Scene getScene() {
        return scene;
    }

    public Camera getCamera() {
        return camera;
    }

    /**
     * La couleur vue à travers un point de l'écran ({@link Camera#getRayon}), non limitée.
     *
     * @param profondeur nombre de réflexions permises
     */
    public Couleur getCouleurPixel(double xe, double ye, int profondeur) {
        scene.getCompteurs().primaires++;
        Rayon initial = camera.getRayon(xe, ye);
        return scene.getCouleurVue(initial, null, profondeur);
    }

    /**
     * Dessine un brouillon, un rayon pour 4 × 4 pixels et une réflexion au plus, puis tous les pixels.
     *
     * @param image la boucle sur l'image, que se partagent des fils : {@link lancer.fils.Traceur}
     * @param profondeur nombre de réflexions permises
     * @param fils nombre de fils d'exécution, au moins 1 ; l'image n'en dépend pas
     */
    public void TracerImage(Boucle image, Toile toile, int profondeur, int fils) {
        image.TracerBrouillon(toile, Math.min(profondeur, Constantes.REFLETS_BROUILLON), fils);
        image.TracerPixels(toile, profondeur, fils);
    }
}
