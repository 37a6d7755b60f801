package lancer.rapide;

import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.essai.Ressources;

/** Une scène que cherchent les structures, même si elle a peu d'objets. */
public final class Structuree {

    private Structuree() {
    }

    public static Scene scene(Scene scene, Camera camera) {
        return Preparation.structurer(scene, camera);
    }

    /** L'image de cette scène, par les structures. */
    public static Ressources.Image imageRapide(Scene scene, Camera camera, int reflets) {
        Ressources.Image image = new Ressources.Image(camera.getLargeur(), camera.getHauteur());
        new Lancer(scene(scene, camera), camera).TracerImage(image, reflets, 2);
        return image;
    }
}
