package lancer.scene;

import java.util.Timer;
import java.util.TimerTask;
import java.util.function.UnaryOperator;

/** Veille sur le fichier de la scène, dans un fil à elle : un éditeur qui renomme échappe aux notifications. */
public final class Surveillance extends TimerTask {

    private static final int PERIODE_MS = 250;

    /** Regards sans le fichier avant de le dire effacé : un éditeur qui renomme le fait disparaître un instant. */
    private static final int ABSENCES = 4;

    private final Timer veille = new Timer("lancer-surveillance", true);
    private final UnaryOperator<String> version;
    private final Runnable siChange;
    private final Runnable siEfface;
    /** Remplacé en entier, sans verrou : qui suit un autre fichier n'attend pas un disque qui ne répond pas. */
    private volatile Suivi suivi = new Suivi(null, null);
    private int absences;
    private String vue;

    /** Un fichier, et sa version déjà dite. */
    private static final class Suivi {

        final String fichier;
        String connue;

        Suivi(String fichier, String connue) {
            this.fichier = fichier;
            this.connue = connue;
        }
    }

    /** @param siChange appelé dans ce fil, une fois par changement @param siEfface de même, s'il n'y a plus rien */
    public Surveillance(Runnable siChange, Runnable siEfface) {
        this(FichierScene::version, siChange, siEfface);
    }

    Surveillance(UnaryOperator<String> version, Runnable siChange, Runnable siEfface) {
        this.version = version;
        this.siChange = siChange;
        this.siEfface = siEfface;
        veille.schedule(this, PERIODE_MS, PERIODE_MS);
    }

    public void terminer() {
        veille.cancel();
    }

    /** @param version celle qui est lue, que {@link FichierScene} a dite avant : ce qui change ensuite est vu */
    public void suivre(String aSuivre, String version) {
        suivi = new Suivi(aSuivre, version);
    }

    /** Dit, une fois, qu'un fichier a changé et n'a plus bougé depuis, ou qu'il n'est plus là. */
    @Override
    public void run() {
        Suivi sien = suivi;
        String nouvelle = sien.fichier == null ? null : version.apply(sien.fichier);
        absences = sien.fichier == null || nouvelle != null ? 0 : absences + 1;
        boolean change = nouvelle != null && nouvelle.equals(vue) && !nouvelle.equals(sien.connue);
        vue = nouvelle;
        // la réponse d'un disque lent ne dit rien de ce qui est suivi depuis
        if (sien == suivi && (change || absences == ABSENCES)) {
            sien.connue = nouvelle;
            (change ? siChange : siEfface).run();
        }
    }
}
