package lancer.scene;

import java.io.IOException;
import java.util.Objects;
import java.util.Timer;
import java.util.TimerTask;
import lancer.SceneFautive;

/** Observation du fichier de la scène. Les notifications du système ne voient pas un éditeur qui renomme le fichier. */
public final class Surveillance {

    private static final int PERIODE_MS = 250;

    private final Runnable siChange;
    private final Timer veille = new Timer("lancer-surveillance", true);
    private volatile Suivi suivi;

    /** @param siChange appelé, dans un autre fil, si le fichier change, disparaît ou revient */
    public Surveillance(Runnable siChange) {
        this.siChange = siChange;
    }

    public void terminer() {
        veille.cancel();
    }

    /** L'heure et la taille du fichier ; {@code null} s'il n'existe pas. */
    public static String version(String fichier) {
        try {
            return SceneLue.version(LecteurScene.trouver(fichier));
        } catch (IOException | SceneFautive e) {
            return null;
        }
    }

    /** Observe ce fichier seul. @param lue sa {@link #version} avant sa lecture, qui peut durer */
    public void suivre(String fichier, String lue) {
        if (suivi != null) {
            suivi.cancel();
        }
        suivi = new Suivi(fichier, lue);
        veille.schedule(suivi, PERIODE_MS, PERIODE_MS);
    }

    private final class Suivi extends TimerTask {

        private final String fichier;
        /** La version annoncée en dernier, puis celle de la dernière observation ; {@code null} s'il est absent. */
        private String annoncee;
        private String vue;

        Suivi(String fichier, String lue) {
            this.fichier = fichier;
            annoncee = lue;
            vue = lue;
        }

        /** Annonce ce que deux observations de suite ont trouvé : un éditeur qui renomme l'efface un instant. */
        @Override
        public void run() {
            String nouvelle = version(fichier);
            boolean stable = Objects.equals(nouvelle, vue);
            vue = nouvelle;
            // un disque lent peut répondre pour un fichier qui n'est plus suivi
            if (this == suivi && stable && !Objects.equals(nouvelle, annoncee)) {
                annoncee = nouvelle;
                siChange.run();
            }
        }
    }
}
