package lancer.atelier;

import java.nio.file.Path;
import lancer.Scene;
import lancer.lecture.LecteurScene;

/** Les scènes telles que la base les voit : les variantes du chemin des classes sont là pour être mesurées, non pour s'y installer. */
public final class Scenes {

    private Scenes() {
    }

    /**
     * Lit une scène, sans variante.
     *
     * @throws lancer.SceneFautive si le fichier ne peut être utilisé
     */
    public static Scene lire(Path fichier) {
        LecteurScene lu = LecteurScene.lire(fichier.toString());
        return new Scene(lu.getObjets(), lu.getLampes());
    }

    /** Mêmes objets et mêmes lampes, rien d'autre. */
    public static Scene nue(Scene scene) {
        return new Scene(scene.getObjets(), scene.getLampes());
    }
}
