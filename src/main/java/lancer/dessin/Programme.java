package lancer.dessin;

import java.util.function.DoubleConsumer;
import lancer.contrat.Toile;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/** Le programme, vu de ce qui le mène, fenêtre ou ligne de commande : de quoi lire une scène et la dessiner. */
public interface Programme extends Toile {

    /** Lit une scène à dessiner : voir {@link LecteurScene#lire}. */
    SceneLue lireScene(String nomFichier, DoubleConsumer suivi);

    /**
     * Dessine la scène, brouillon puis image : le travail du SwingWorker de la fenêtre.
     *
     * @throws java.util.concurrent.CancellationException si le dessin a été arrêté
     * @throws lancer.commande.Echec si un pixel ne peut être calculé
     */
    void doTracerImage(int largeur, int hauteur);
}
