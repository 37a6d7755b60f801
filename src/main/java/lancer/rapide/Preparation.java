package lancer.rapide;

import lancer.Camera;
import lancer.Scene;

/** La recherche d'une scène et d'une image. */
public final class Preparation {

    private Preparation() {
    }

    /** La même scène, avec sa recherche. @throws java.util.concurrent.CancellationException si ce fil est interrompu */
    public static Scene preparer(Scene scene, Camera camera) {
        return scene;
    }
}
