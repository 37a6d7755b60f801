package lancer.scene;

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
    /** Remplacé en entier, sans verrou : changer de fichier n'attend pas un disque qui ne répond pas. */
    private volatile Suivi suivi = new Suivi(null, null);
    private int absences;
    private String vue;

    /** Un fichier, et sa dernière version annoncée. */
    private static final class Suivi {

        final String fichier;
        String connue;

        Suivi(String fichier, String connue) {
            this.fichier = fichier;
            this.connue = connue;
        }
    }

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
        suivi = new Suivi(aSuivre, version);
    }

    /** Annonce une version nouvelle que deux observations de suite ont trouvée, ou la disparition du fichier. */
    @Override
    public void run() {
        Suivi sien = suivi;
        String nouvelle = sien.fichier == null ? null : version.apply(sien.fichier);
        absences = sien.fichier == null || nouvelle != null ? 0 : absences + 1;
        boolean change = nouvelle != null && nouvelle.equals(vue) && !nouvelle.equals(sien.connue);
        vue = nouvelle;
        // un disque lent peut répondre pour un fichier qui n'est plus suivi
        if (sien == suivi && (change || absences == ABSENCES)) {
            sien.connue = nouvelle;
            (change ? siChange : siEfface).run();
        }
    }
}
