package lancer.scene;

import java.util.Timer;
import java.util.TimerTask;

/** Observation du fichier de la scène. Les notifications du système ne voient pas un éditeur qui renomme le fichier. */
public final class Surveillance {

    private static final int PERIODE_MS = 250;

    /** Nombre d'absences avant de dire le fichier effacé : un éditeur qui renomme l'efface un instant. */
    private static final int ABSENCES = 4;

    private final int periodeMs;
    private final Timer veille = new Timer("lancer-surveillance", true);
    private final Runnable siChange;
    private final Runnable siEfface;
    private volatile Suivi suivi;

    /** @param siChange appelé à chaque changement, dans un autre fil @param siEfface appelé si le fichier disparaît */
    public Surveillance(Runnable siChange, Runnable siEfface) {
        this(PERIODE_MS, siChange, siEfface);
    }

    /** @param periodeMs temps d'une observation à l'autre, en millisecondes */
    Surveillance(int periodeMs, Runnable siChange, Runnable siEfface) {
        this.periodeMs = periodeMs;
        this.siChange = siChange;
        this.siEfface = siEfface;
    }

    public void terminer() {
        veille.cancel();
    }

    /** Observe ce fichier seul. @param lue sa {@link FichierScene#version} avant sa lecture, qui peut durer */
    public void suivre(String fichier, String lue) {
        if (suivi != null) {
            suivi.cancel();
        }
        suivi = new Suivi(fichier, lue);
        veille.schedule(suivi, periodeMs, periodeMs);
    }

    private final class Suivi extends TimerTask {

        private final String fichier;
        /** La version annoncée en dernier, puis celle de la dernière observation. */
        private String annoncee;
        private String vue;
        private int absences;

        Suivi(String fichier, String lue) {
            this.fichier = fichier;
            annoncee = lue;
        }

        /** Annonce une version nouvelle que deux observations de suite ont trouvée, ou la disparition du fichier. */
        @Override
        public void run() {
            String nouvelle = FichierScene.version(fichier);
            absences = nouvelle == null ? absences + 1 : 0;
            boolean change = nouvelle != null && nouvelle.equals(vue) && !nouvelle.equals(annoncee);
            boolean efface = absences == ABSENCES && annoncee != null;
            vue = nouvelle;
            // un disque lent peut répondre pour un fichier qui n'est plus suivi
            if (this == suivi && (change || efface)) {
                annoncee = nouvelle;
                (change ? siChange : siEfface).run();
            }
        }
    }
}
