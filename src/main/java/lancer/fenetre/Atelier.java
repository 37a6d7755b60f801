package lancer.fenetre;

import java.awt.Dimension;
import java.io.PrintStream;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import lancer.Main;

/**
 * Où se font les images de la fenêtre. Un seul fil, donc une image à la fois : la suivante attend là, et non sur le fil
 * des événements, que celle qu'on abandonne ait vraiment fini d'écrire.
 */
final class Atelier {

    private final Main main;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private final Surveillance surveillance = new Surveillance();
    private final ExecutorService dessins = Executors.newSingleThreadExecutor(new FilDemon("lancer-dessin"));

    /**
     * @param sortie où vont les statistiques, si elles sont demandées
     * @param erreur où va ce que les témoins d'un dessin ont vu de faux
     */
    Atelier(Main main, PrintStream sortie, PrintStream erreur) {
        this.main = main;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** Lit la première scène, dans le fil de l'appelant. */
    void lire(String fichier) {
        surveillance.suivre(fichier);
        main.lireScene(fichier);
    }

    /**
     * Demande une image.
     *
     * @param aLire la scène à lire d'abord, {@code null} si elle l'est déjà
     */
    Tracage dessiner(String aLire, Dimension taille) {
        Tracage tracage = new Tracage(main, aLire, taille, surveillance, sortie, erreur);
        dessins.execute(tracage);
        return tracage;
    }

    /** @param siChange appelé, dans un fil à part, chaque fois que le fichier lu en dernier a changé */
    void surveiller(Runnable siChange) {
        surveillance.commencer(siChange);
    }

    void terminer() {
        surveillance.terminer();
        dessins.shutdown();
    }
}
