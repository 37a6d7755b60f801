package lancer.scene;

import java.util.AbstractMap.SimpleEntry;
import java.util.Map;
import java.util.Timer;
import java.util.TimerTask;
import java.util.function.UnaryOperator;

/** Observation du fichier de la scène. Les notifications du système ne voient pas un éditeur qui renomme le fichier. */
public final class Surveillance extends TimerTask {

    private static final int PERIODE_MS = 250;

    /** Nombre d'absences avant de dire le fichier effacé : un éditeur qui renomme l'efface un instant. */
    private static final int ABSENCES = 4;

    private final Timer veille = new Timer("lancer-surveillance", true);
    private final UnaryOperator<String> version;
    private final Runnable siChange;
    private final Runnable siEfface;
    /** Le fichier et sa dernière version annoncée, remplacés sans verrou : un disque peut ne pas répondre. */
    private volatile Map.Entry<String, String> suivi = new SimpleEntry<>(null, null);
    private int absences;
    private String vue;

    /** @param siChange appelé à chaque changement, dans ce fil @param siEfface appelé si le fichier disparaît */
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

    /** @param version celle de {@link FichierScene} avant la lecture : un changement pendant la lecture est vu */
    public void suivre(String aSuivre, String version) {
        suivi = new SimpleEntry<>(aSuivre, version);
    }

    /** Annonce une version nouvelle que deux observations de suite ont trouvée, ou la disparition du fichier. */
    @Override
    public void run() {
        Map.Entry<String, String> sien = suivi;
        String nouvelle = sien.getKey() == null ? null : version.apply(sien.getKey());
        absences = sien.getKey() == null || nouvelle != null ? 0 : absences + 1;
        boolean change = nouvelle != null && nouvelle.equals(vue) && !nouvelle.equals(sien.getValue());
        vue = nouvelle;
        // un disque lent peut répondre pour un fichier qui n'est plus suivi
        if (sien == suivi && (change || absences == ABSENCES)) {
            sien.setValue(nouvelle);
            (change ? siChange : siEfface).run();
        }
    }
}
