package lancer.fenetre;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Timer;
import java.util.TimerTask;
import lancer.SceneFautive;
import lancer.scene.FichierScene;

/**
 * Veille sur le fichier de la scène, dans un fil à elle. Elle regarde l'heure et la taille, car un éditeur qui
 * enregistre en renommant échappe aux notifications du système.
 */
final class Surveillance extends TimerTask {

    private static final int PERIODE_MS = 250;

    private final Timer veille = new Timer("lancer-surveillance", true);
    private final Runnable siChange;
    private String fichier;
    private String connue;
    private String vue;

    /** @param siChange appelé dans le fil de la surveillance, une fois par changement */
    Surveillance(Runnable siChange) {
        this.siChange = siChange;
        veille.schedule(this, PERIODE_MS, PERIODE_MS);
    }

    void terminer() {
        veille.cancel();
    }

    /** @param version celle qui est lue, prise par {@link #version} avant de lire : ce qui change ensuite est vu */
    synchronized void suivre(String aSuivre, String version) {
        fichier = aSuivre;
        connue = version;
    }

    @Override
    public void run() {
        if (regarder()) {
            siChange.run();
        }
    }

    /** @return vrai, une fois, si le fichier a changé et n'a plus bougé depuis : l'éditeur a fini d'écrire */
    private synchronized boolean regarder() {
        String nouvelle = fichier == null ? null : version(fichier);
        // absent : on l'enregistre, il revient
        boolean change = nouvelle != null && nouvelle.equals(vue) && !nouvelle.equals(connue);
        vue = nouvelle;
        if (change) {
            connue = nouvelle;
        }
        return change;
    }

    /** L'heure, la taille et l'identité du fichier ; {@code null} s'il n'existe pas. */
    static String version(String fichier) {
        try {
            BasicFileAttributes a = Files.readAttributes(FichierScene.trouver(fichier), BasicFileAttributes.class);
            return a.lastModifiedTime() + " " + a.size() + " " + a.fileKey();
        } catch (IOException | SceneFautive e) {
            return null;
        }
    }
}
