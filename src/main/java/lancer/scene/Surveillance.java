package lancer.scene;

import java.io.IOException;
import java.util.Timer;
import java.util.TimerTask;
import java.util.function.BiConsumer;
import lancer.SceneFautive;

/** Observation du fichier de la scène. Les notifications du système ne voient pas un éditeur qui renomme le fichier. */
public final class Surveillance {

    private static final int PERIODE_MS = 250;
    private static final String ABSENT = "absent";

    private final Timer veille = new Timer("lancer-surveillance", true);
    private TimerTask observation;
    private final BiConsumer<String, String> siVu;

    /** @param siVu reçoit, dans un autre fil, le nom du fichier et la version que deux observations ont trouvée */
    public Surveillance(BiConsumer<String, String> siVu) {
        this.siVu = siVu;
    }

    public void terminer() {
        veille.cancel();
    }

    /** L'heure et la taille du fichier ; un mot s'il n'existe pas. */
    public static String version(String fichier) {
        try {
            return SceneLue.version(LecteurScene.trouver(fichier));
        } catch (IOException | SceneFautive e) {
            return ABSENT;
        }
    }

    /** Observe ce fichier seul. */
    public void suivre(String fichier) {
        if (observation != null) {
            observation.cancel();
        }
        observation = new TimerTask() {
            private String vue;

            /** Annonce ce que deux observations de suite ont trouvé : un éditeur qui renomme l'efface un instant. */
            @Override
            public void run() {
                String nouvelle = version(fichier);
                if (nouvelle.equals(vue)) {
                    siVu.accept(fichier, nouvelle);
                }
                vue = nouvelle;
            }
        };
        veille.schedule(observation, PERIODE_MS, PERIODE_MS);
    }
}
