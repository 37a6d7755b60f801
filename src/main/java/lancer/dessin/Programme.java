package lancer.dessin;

import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/** Le programme, tel que s'en servent la fenêtre et l'écriture d'un fichier : il lit une scène, et la dessine. */
public interface Programme {

    /** Voir {@link LecteurScene#lire}. */
    default SceneLue lire(String fichier, DoubleConsumer suivi) {
        return LecteurScene.lireEtGarder(fichier, suivi);
    }

    /**
     * Dessine cette demande.
     *
     * @param suivi reçoit le dessin quand il commence, puis quand son brouillon est fini
     * @return le dessin achevé
     */
    Dessin dessiner(Demande demande, Consumer<Dessin> suivi);
}
