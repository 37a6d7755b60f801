package lancer.sortie;

import java.util.List;
import java.util.concurrent.CancellationException;
import lancer.Lancer;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.Echec;

/** Ce que la fenêtre demande au programme : lire une scène, la dessiner, et laisser voir où il en est. */
public interface Dessinateur {

    /**
     * Lit une scène, qui devient celle à dessiner.
     *
     * @param fichier voir {@link Scene#Scene(String)}
     * @return ce qu'elle a de laissé de côté, une ligne chacun
     * @throws SceneFautive si elle ne peut être utilisée ; la précédente reste alors en place
     * @throws CancellationException de même, si ce fil a été interrompu
     */
    List<String> lireScene(String fichier);

    /** La part faite de la lecture, ou de la préparation, de 0 à 1. */
    double getAvancement();

    /** Comment dessiner la scène lue, tant que {@link #regler} n'en dit pas plus. */
    ReglagesDessin getReglages();

    /**
     * Dit comment dessiner la scène lue, jusqu'à la suivante.
     *
     * @throws SceneFautive si ces réglages ne vont pas ; rien n'est alors changé
     */
    void regler(ReglagesDessin reglages);

    /**
     * Dessine la scène lue, brouillon puis image.
     *
     * @throws CancellationException si le dessin a été arrêté
     * @throws Echec si un pixel ne peut être calculé
     */
    void doTracerImage(int largeur, int hauteur);

    /** L'image que dessine, ou qu'a dessinée, {@link #doTracerImage} ; {@code null} avant la première. */
    ImageMemoire getImage();

    /** Ce qui dessine cette image ; {@code null} tant que la scène se prépare. */
    Lancer getLancer();
}
