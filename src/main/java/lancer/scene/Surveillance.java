package lancer.scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import lancer.SceneFautive;

/** Observation du fichier de la scène. Les notifications du système ne voient pas un éditeur qui renomme le fichier. */
public final class Surveillance implements Runnable {

    /** La version d'un fichier qui n'existe pas. */
    public static final String ABSENT = "absent";
    private static final int PERIODE_MS = 250;

    /** Sur une horloge qui ne recule pas, au contraire de celle de {@link java.util.Timer}. */
    private final ScheduledExecutorService veille = Executors.newSingleThreadScheduledExecutor(tache -> {
        Thread fil = new Thread(tache, "lancer-surveillance");
        fil.setDaemon(true);
        return fil;
    });
    private final BiConsumer<String, String> siVu;
    private volatile String suivi;
    /** Le fichier, son heure et sa taille à l'observation d'avant, et sa version si elles n'ont pas changé depuis. */
    private String vus;
    private String version;

    /** @param siVu reçoit, dans un autre fil, le nom du fichier et la version que deux observations ont trouvée */
    public Surveillance(BiConsumer<String, String> siVu) {
        this.siVu = siVu;
        veille.scheduleAtFixedRate(this, PERIODE_MS, PERIODE_MS, TimeUnit.MILLISECONDS);
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
            String vu = fichier + " " + dater(fichier);
            if (!vu.equals(vus)) {
                version = null;
            } else if (version == null) {
                version = version(fichier);
            }
            vus = vu;
            if (version != null) {
                siVu.accept(fichier, version);
            }
        }
    }

    /** L'heure et la taille du fichier ; un mot s'il n'existe pas. */
    private static String dater(String fichier) {
        try {
            BasicFileAttributes a = Files.readAttributes(LecteurScene.trouver(fichier), BasicFileAttributes.class);
            return a.lastModifiedTime() + " " + a.size();
        } catch (IOException | SceneFautive e) {
            return ABSENT;
        }
    }

    /** Ce que deux fichiers de mêmes octets ont en commun ; un mot s'il n'existe pas. */
    public static String version(String fichier) {
        try {
            Path chemin = LecteurScene.trouver(fichier);
            // un tube ne se lit qu'une fois
            return Files.isRegularFile(chemin) ? TexteScene.version(Files.readAllBytes(chemin)) : dater(fichier);
        } catch (IOException | SceneFautive e) {
            return ABSENT;
        }
    }

    public void terminer() {
        veille.shutdownNow();
    }
}
