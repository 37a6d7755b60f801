package lancer.scene;

import java.util.function.DoubleConsumer;

/** Lecture d'une scène, telle que le programme la fait ({@link LecteurScene#lire}). */
public interface Lecture {

    /** @param suivi appelé à mesure, avec la part lue du fichier, de 0 à 1 */
    SceneLue lireScene(String nomFichier, DoubleConsumer suivi);
}
