package lancer.fenetre;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Timer;
import java.util.TimerTask;
import lancer.SceneFautive;
import lancer.lecture.LecteurScene;

/**
 * Veille sur le fichier de la scène, dans un fil à elle. Elle regarde l'heure et la taille, car un éditeur qui
 * enregistre en renommant échappe aux notifications du système.
 */
final class Surveillance {

    private static final int PERIODE_MS = 250;

    private final Timer veille = new Timer("lancer-surveillance", true);
    private String fichier;
    private String connu;
    private String vu;

    /** À appeler juste avant de lire le fichier : ce qui changera ensuite sera vu. */
    synchronized void suivre(String aSuivre) {
        fichier = aSuivre;
        connu = etat(aSuivre);
    }

    /** @param siChange appelé dans le fil de la surveillance, une fois par changement */
    void commencer(Runnable siChange) {
        veille.schedule(new TimerTask() {
            @Override
            public void run() {
                if (regarder()) {
                    siChange.run();
                }
            }
        }, PERIODE_MS, PERIODE_MS);
    }

    void terminer() {
        veille.cancel();
    }

    /** @return vrai, une fois, si le fichier a changé et n'a plus bougé depuis : l'éditeur a fini d'écrire */
    private synchronized boolean regarder() {
        String nouveau = fichier == null ? null : etat(fichier);
        // absent : on l'enregistre, il revient
        boolean change = nouveau != null && nouveau.equals(vu) && !nouveau.equals(connu);
        vu = nouveau;
        if (change) {
            connu = nouveau;
        }
        return change;
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
