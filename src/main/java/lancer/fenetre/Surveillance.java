package lancer.fenetre;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.attribute.BasicFileAttributes;
import lancer.SceneFautive;
import lancer.lecture.LecteurScene;

/**
 * Veille sur le fichier de la scène, dans un fil à elle. Elle regarde l'heure et la taille, car un éditeur qui
 * enregistre en renommant échappe aux notifications du système.
 */
final class Surveillance implements Runnable {

    private static final int PERIODE_MS = 500;

    /** Temps qu'on laisse à un éditeur pour finir d'écrire, en millisecondes. */
    private static final int REPOS_MS = 60;

    private Thread fil;
    private Runnable siChange;
    private String fichier;
    private String connu;

    /** À appeler juste avant de lire le fichier : ce qui changera ensuite sera vu. */
    void suivre(String fichier) {
        String etat = etat(fichier);
        synchronized (this) {
            this.fichier = fichier;
            this.connu = etat;
        }
    }

    /** @param siChange appelé dans le fil de la surveillance, une fois par changement */
    void commencer(Runnable siChange) {
        this.siChange = siChange;
        fil = new FilDemon("lancer-surveillance").newThread(this);
        fil.start();
    }

    void terminer() {
        fil.interrupt();
    }

    @Override
    public void run() {
        try {
            String precedent = null;
            while (true) {
                Thread.sleep(precedent == null ? PERIODE_MS : REPOS_MS);
                String nouveau = nouveau();
                // deux fois le même : l'éditeur a fini d'écrire
                if (nouveau != null && nouveau.equals(precedent)) {
                    if (prendre(nouveau)) {
                        siChange.run();
                    }
                    nouveau = null;
                }
                precedent = nouveau;
            }
        } catch (InterruptedException e) {
            // la fenêtre se ferme
        }
    }

    /** L'état du fichier s'il a changé ; {@code null} sinon, ou s'il a disparu : on enregistre, il revient. */
    private String nouveau() {
        String suivi;
        String ancien;
        synchronized (this) {
            suivi = fichier;
            ancien = connu;
        }
        String etat = suivi == null ? null : etat(suivi);
        return etat == null || etat.equals(ancien) ? null : suivi + " " + etat;
    }

    /** Retient l'état vu, sauf si entre-temps on suit un autre fichier. */
    private synchronized boolean prendre(String nouveau) {
        if (!nouveau.startsWith(fichier + " ")) {
            return false;
        }
        connu = nouveau.substring(fichier.length() + 1);
        return true;
    }

    /** L'heure, la taille et l'identité du fichier ; {@code null} s'il n'existe pas. */
    private static String etat(String fichier) {
        try {
            BasicFileAttributes a = Files.readAttributes(LecteurScene.trouver(fichier), BasicFileAttributes.class);
            return a.lastModifiedTime() + " " + a.size() + " " + a.fileKey();
        } catch (IOException | SceneFautive e) {
            return null;
        }
    }
}
