package lancer.dessin;

import lancer.Scene;
import lancer.contrat.Toile;
import lancer.scene.LecteurScene;

/** Le programme, vu de ce qui le mène, fenêtre ou ligne de commande : une scène, et de quoi la dessiner. */
public interface Programme extends Toile {

    /** Lit une scène, qui devient celle à dessiner : voir {@link Scene#Scene(String, LecteurScene)}. */
    void lireScene(String nomFichier, LecteurScene lecteur);

    /** La scène lue, {@code null} tant qu'aucune ne l'est. */
    Scene getScene();

    /**
     * Dessine la scène, brouillon puis image : le travail du SwingWorker de la fenêtre.
     *
     * @throws java.util.concurrent.CancellationException si le dessin a été arrêté
     * @throws lancer.commande.Echec si un pixel ne peut être calculé
     */
    void doTracerImage(int largeur, int hauteur);
}
