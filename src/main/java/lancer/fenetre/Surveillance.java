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

    /** Regards sans le fichier avant de le dire effacé : un éditeur qui renomme le fait disparaître un instant. */
    private static final int ABSENCES = 4;

    private final Timer veille = new Timer("lancer-surveillance", true);
    private final Runnable siChange;
    private final Runnable siEfface;
    private int absences;
    private String fichier;
    private String connue;
    private String vue;

    /**
     * @param siChange appelé dans le fil de la surveillance, une fois par changement
     * @param siEfface appelé de même quand le fichier a disparu ; qu'il revienne est un changement
     */
    Surveillance(Runnable siChange, Runnable siEfface) {
        this.siChange = siChange;
        this.siEfface = siEfface;
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
        Runnable nouvelle = regarder();
        if (nouvelle != null) {
            nouvelle.run();
        }
    }

    /** Ce qu'il y a à faire, une fois, d'un fichier qui a changé et n'a plus bougé depuis, ou qui n'est plus là. */
    private synchronized Runnable regarder() {
        String nouvelle = fichier == null ? null : version(fichier);
        absences = fichier == null || nouvelle != null ? 0 : absences + 1;
        boolean change = nouvelle != null && nouvelle.equals(vue) && !nouvelle.equals(connue);
        vue = nouvelle;
        if (change || absences == ABSENCES) {
            connue = nouvelle;
        }
        return change ? siChange : absences == ABSENCES ? siEfface : null;
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
