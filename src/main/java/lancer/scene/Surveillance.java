package lancer.scene;

import java.io.IOException;
import java.util.Timer;
import java.util.TimerTask;
import java.util.function.BiConsumer;
import lancer.SceneFautive;

/** Observation du fichier de la scène. Les notifications du système ne voient pas un éditeur qui renomme le fichier. */
public final class Surveillance extends TimerTask {

    private static final int PERIODE_MS = 250;
    private static final String ABSENT = "absent";

    private final Timer veille = new Timer("lancer-surveillance", true);
    private final BiConsumer<String, String> siVu;
    private volatile String suivi;
    /** Le fichier et la version de l'observation d'avant. */
    private String vus;

    /** @param siVu reçoit, dans un autre fil, le nom du fichier et la version que deux observations ont trouvée */
    public Surveillance(BiConsumer<String, String> siVu) {
        this.siVu = siVu;
        veille.schedule(this, PERIODE_MS, PERIODE_MS);
    }

    /** Observe désormais ce fichier. */
    public void suivre(String fichier) {
        suivi = fichier;
    }

    /** Annonce ce que deux observations de suite ont trouvé : un éditeur qui renomme l'efface un instant. */
    @Override
    public void run() {
        String fichier = suivi;
        if (fichier != null) {
            String version = version(fichier);
            if ((fichier + version).equals(vus)) {
                siVu.accept(fichier, version);
            }
            vus = fichier + version;
        }
    }

    /** L'heure et la taille du fichier ; un mot s'il n'existe pas. */
    public static String version(String fichier) {
        try {
            return SceneLue.version(LecteurScene.trouver(fichier));
        } catch (IOException | SceneFautive e) {
            return ABSENT;
        }
    }

    public void terminer() {
        veille.cancel();
    }
}
