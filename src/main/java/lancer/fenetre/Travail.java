package lancer.fenetre;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Programme;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;

/**
 * Un dessin de la fenêtre (cours, « Bilan intermédiaire ») : lire la scène si elle ne l'est pas, puis dessiner le
 * brouillon et l'image.
 */
final class Travail extends SwingWorker<Void, Void> {

    /** Temps de dessin avant de dire ce qui en reste. */
    private static final long RESTE_NS = 2_000_000_000;

    private final Programme programme;
    private final Reglages options;
    /** Le fichier de la scène à lire ; {@code null} si elle est lue. */
    final String aLire;
    /** Ce qui est demandé ; pendant la lecture, de la scène d'avant, ou {@code null}. */
    volatile Demande demande;
    /** Le dessin ; {@code null} avant la préparation. */
    volatile Dessin dessin;
    /** Vrai quand chaque pixel de ce dessin a une couleur. */
    private volatile boolean brouillonFait;
    private volatile double partLue;
    /** Vrai quand la scène est lue. */
    volatile boolean lue;
    /** La version du fichier avant sa lecture, même si elle a échoué ; {@code null} s'il n'existait pas. */
    volatile String version;
    private final long debut = System.nanoTime();
    private volatile long debutDuDessin;
    /** 0 avant la fin. */
    private long fin;
    /**
     * Reçoit ce travail, dans le fil des événements, quand la scène est lue, quand le dessin commence, quand le
     * brouillon est fait, et à la fin. Le premier travail commence avant que la fenêtre soit faite.
     */
    Consumer<Travail> suite;

    /** Le dessin d'une scène lue. */
    Travail(Programme programme, Demande demande) {
        this(programme, demande.reglages, null, demande);
    }

    /** Le dessin d'une scène à lire. @param avant la demande dont les réglages restent, ou {@code null} */
    Travail(Programme programme, Reglages options, String aLire, Demande avant) {
        this.programme = programme;
        this.options = options;
        this.aLire = aLire;
        demande = avant;
        lue = aLire == null;
    }

    @Override
    protected Void doInBackground() {
        if (aLire != null) {
            version = Surveillance.version(aLire);
            SceneLue scene = programme.lire(aLire, part -> partLue = part);
            demande = demande == null ? new Demande(scene, options) : demande.avecLecture(scene);
            lue = true;
            publish();
        }
        programme.dessiner(demande, celui -> {
            brouillonFait = dessin != null;
            celui.lancer.getAtelier().getFautes().tolerer();
            dessin = celui;
            debutDuDessin = System.nanoTime();
            publish();
        });
        return null;
    }

    @Override
    protected void process(List<Void> etapes) {
        suite.accept(this);
    }

    @Override
    protected void done() {
        fin = System.nanoTime();
        suite.accept(this);
    }

    boolean estFini() {
        return fin != 0;
    }

    boolean aSonBrouillon() {
        return brouillonFait;
    }

    /** L'échec qui a arrêté ce travail ; {@code null} s'il est en cours, achevé, ou arrêté sur demande. */
    Throwable getEchec() {
        try {
            if (isDone() && !isCancelled()) {
                get();
            }
            return null;
        } catch (ExecutionException | InterruptedException e) {
            return e.getCause();
        }
    }

    boolean estAcheve() {
        return isDone() && !isCancelled() && getEchec() == null;
    }

    /** La part faite de la lecture, ou de l'image, de 0 à 1. */
    double getAvancement() {
        if (!lue) {
            return partLue;
        }
        return aSonBrouillon() ? dessin.lancer.getAtelier().getAvancement() : 0;
    }

    /** Ce que ce travail fait ou a fait, en une ligne. */
    String getTexte() {
        // le résumé d'une image donne le temps du dessin seul ; celui-ci compte aussi la lecture
        long jusque = estFini() ? fin : System.nanoTime();
        String temps = String.format(Locale.FRANCE, " — %.2f s", (jusque - debut) / 1e9);
        if (isCancelled()) {
            return direEtape() + ", arrêt" + temps;
        }
        if (isDone()) {
            return (estAcheve() ? "terminé" : "échec") + temps;
        }
        String vue = aSonBrouillon() && demande.vue != null ? " ; " + dessin.image.echelle : "";
        return direEtape() + temps + direReste() + vue;
    }

    private String direEtape() {
        String etape = aSonBrouillon() ? "dessin" : "brouillon";
        if (dessin == null) {
            etape = lue ? "préparation" : "lecture";
        }
        return etape + " " + (int) (100 * getAvancement()) + " %";
    }

    /** Le temps qui reste au dessin, d'après ce qui en est fait ; vide tant qu'il ne peut être estimé. */
    private String direReste() {
        long passe = System.nanoTime() - debutDuDessin;
        if (!aSonBrouillon() || passe < RESTE_NS || getAvancement() == 0) {
            return "";
        }
        double s = passe * (1 - getAvancement()) / getAvancement() / 1e9;
        return ", reste " + (s < 60 ? Math.round(s) + " s" : Math.round(s / 60) + " min");
    }
}
