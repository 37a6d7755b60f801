package lancer.rapide;

import lancer.Camera;
import lancer.Scene;

/** Ce que la recherche pourrait cacher, demandé au hasard avant le dessin. */
public final class Regard {

    private Regard() {
    }

    /** Dit si la recherche de cette scène préparée cache une réponse de ses objets. */
    public static boolean trouveUneReponseCachee(Scene preparee, Camera camera) {
        return false;
    }
}
