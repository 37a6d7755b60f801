package lancer.fenetre;

import java.awt.Dimension;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import lancer.Scene;

/**
 * Où se font les images de la fenêtre. Un seul fil, donc une image à la fois : la suivante attend là, et non sur le fil
 * des événements, que celle qu'on abandonne ait vraiment fini d'écrire.
 */
final class Atelier {

    private final Dessinateur dessinateur;
    private final Surveillance surveillance = new Surveillance();
    private final ExecutorService dessins = Executors.newSingleThreadExecutor(tache -> {
        Thread fil = new Thread(tache, "lancer-dessin");
        fil.setDaemon(true);
        return fil;
    });

    Atelier(Dessinateur dessinateur) {
        this.dessinateur = dessinateur;
    }

    /** Lit la première scène, dans le fil de l'appelant. */
    Scene lire(String fichier) {
        surveillance.suivre(fichier);
        return dessinateur.lireScene(fichier);
    }

    /**
     * Demande une image.
     *
     * @param aLire la scène à lire d'abord, {@code null} si elle l'est déjà
     */
    Tracage dessiner(String aLire, Dimension taille) {
        Tracage tracage = new Tracage(dessinateur, aLire, taille, surveillance);
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
