package lancer.scene;

import java.util.Timer;
import java.util.TimerTask;

/** Veille sur le fichier de la scène, dans un fil à elle : un éditeur qui renomme échappe aux notifications. */
public final class Surveillance extends TimerTask {

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

    /** @param siChange appelé dans ce fil, une fois par changement @param siEfface de même, s'il n'y a plus rien */
    public Surveillance(Runnable siChange, Runnable siEfface) {
        this.siChange = siChange;
        this.siEfface = siEfface;
        veille.schedule(this, PERIODE_MS, PERIODE_MS);
    }

    public void terminer() {
        veille.cancel();
    }

    /** @param version celle qui est lue, que {@link FichierScene} a dite avant : ce qui change ensuite est vu */
    public synchronized void suivre(String aSuivre, String version) {
        fichier = aSuivre;
        connue = version;
    }

    /** Dit, une fois, qu'un fichier a changé et n'a plus bougé depuis, ou qu'il n'est plus là. */
    @Override
    public synchronized void run() {
        String nouvelle = fichier == null ? null : FichierScene.version(fichier);
        absences = fichier == null || nouvelle != null ? 0 : absences + 1;
        boolean change = nouvelle != null && nouvelle.equals(vue) && !nouvelle.equals(connue);
        vue = nouvelle;
        if (change || absences == ABSENCES) {
            connue = nouvelle;
            (change ? siChange : siEfface).run();
        }
    }
}
