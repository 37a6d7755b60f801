package lancer.scene;

import java.util.function.DoubleConsumer;

/** Lecture d'une scène, comme {@link LecteurScene#lire}. */
public interface Lecture {

    /** @param suivi reçoit la part lue du fichier, de 0 à 1 */
    SceneLue lireScene(String nomFichier, DoubleConsumer suivi);
}
