package lancer.dessin;

import java.util.function.DoubleConsumer;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/** Une scène lue dans un fichier. Immuable. */
public final class Lecture {

    /** Le nom du fichier, tel qu'il est demandé. */
    public final String fichier;
    public final SceneLue lue;
    /** Les objets, les lampes et la caméra, sans réglage. */
    public final Scene scene;
    /** Le temps de la lecture, en nanosecondes. */
    public final long dureeNs;

    /** Une scène que l'on a lue, ou changée depuis. */
    public Lecture(String fichier, SceneLue lue, long dureeNs) {
        this.fichier = fichier;
        this.lue = lue;
        this.dureeNs = dureeNs;
        scene = new Scene(lue.objets, lue.lampes, lue.getCadrage());
    }

    /**
     * Lit cette scène.
     *
     * @param suivi reçoit la part lue du fichier, de 0 à 1
     * @throws SceneFautive si le fichier ne peut être utilisé
     * @throws java.util.concurrent.CancellationException si ce fil est interrompu
     */
    public static Lecture lire(String fichier, DoubleConsumer suivi) {
        long debut = System.nanoTime();
        SceneLue lue = LecteurScene.lire(fichier, suivi);
        return new Lecture(fichier, lue, System.nanoTime() - debut);
    }
}
