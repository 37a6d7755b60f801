package lancer.rapide;

import lancer.Camera;
import lancer.Scene;

/** Une scène que cherchent les structures, même si elle a peu d'objets. */
public final class Structuree {

    private Structuree() {
    }

    public static Scene scene(Scene scene, Camera camera) {
        return Preparation.structurer(scene, camera);
    }
}
