package lancer.fenetre;

import java.util.concurrent.ThreadFactory;

/** Des fils nommés, qui n'empêchent pas le programme de finir. */
final class FilDemon implements ThreadFactory {

    private final String nom;

    FilDemon(String nom) {
        this.nom = nom;
    }

    @Override
    public Thread newThread(Runnable tache) {
        Thread fil = new Thread(tache, nom);
        fil.setDaemon(true);
        return fil;
    }
}
