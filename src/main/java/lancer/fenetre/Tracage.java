package lancer.fenetre;

import java.awt.Dimension;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.SwingWorker;
import lancer.Constantes;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.dessin.Dessin;
import lancer.scene.FichierScene;
import lancer.scene.SceneLue;

/** Travail d'un dessin de la fenêtre, dans un autre fil : lire la scène si besoin, la préparer, la dessiner. */
final class Tracage extends SwingWorker<Void, Void> {

    /** Attente maximale de l'affichage du brouillon. */
    private static final long PATIENCE_MS = 2000;

    /** Temps passé à une étape avant de dire ce qui en reste. */
    private static final long RESTE_NS = 2_000_000_000;

    /** Temps laissé à un geste pour continuer. */
    private static final long GESTE_MS = 150;

    final Dessin dessin;
    final boolean aLire;
    private final Consumer<Dessin> programme;
    private final Choix voulu;
    /** La taille de l'image à l'écran. */
    private final Dimension place;
    private final int fils;
    private final long debut = System.nanoTime();
    /** La version du fichier lu, même si sa lecture a échoué. */
    volatile String version;
    /** Ce que dit ce fichier, sans aucun déplacement, puis ce qui est dessiné ; {@code null} avant sa lecture. */
    private volatile Choix lu;
    volatile Choix choix;
    /** Vrai quand la fenêtre a montré que la scène est lue, puis qu'un calcul dure. */
    boolean lueDite;
    boolean lenteurDite;
    private String etape;
    private long debutEtapeNs;
    private volatile long fin;
    private volatile Throwable echec;
    private final CountDownLatch lue = new CountDownLatch(1);
    /** Ouvert quand le brouillon est affiché : l'image peut se dessiner. */
    final CountDownLatch vue = new CountDownLatch(1);

    /**
     * @param voulu ce qui est choisi, {@code null} pour ce que disent la ligne de commande et le fichier
     * @param place la taille de l'image à l'écran, en pixels
     */
    Tracage(Consumer<Dessin> programme, Dessin dessin, Choix voulu, Dimension place, int fils) {
        this.place = place;
        this.fils = fils;
        this.programme = programme;
        this.dessin = dessin;
        this.voulu = voulu;
        aLire = dessin.getLue() == null;
        choix = aLire ? null : voulu;
    }

    Choix getLu() {
        return lu;
    }

    /** La scène lue par ce dessin, telle qu'elle est dans son fichier. */
    SceneLue getLue() {
        return lu.lue;
    }

    boolean litLaSceneDe(Tracage autre) {
        return autre != null && dessin.fichier.equals(autre.dessin.fichier);
    }

    /** Attend la fin ou l'échec de la lecture, {@code ms} millisecondes au plus ; lève l'exception de l'échec. */
    void attendreLecture(long ms) {
        try {
            lue.await(ms, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            throw Echec.machine("interrompu");
        }
        if (dessin.getLue() == null && echec instanceof Error) {
            throw (Error) echec;
        } else if (dessin.getLue() == null && echec != null) {
            throw (RuntimeException) echec;
        }
    }

    /** Attend l'affichage du brouillon : l'ouverture de la fenêtre a d'abord besoin des processeurs. */
    void attendreDEtreVu() {
        try {
            vue.await(PATIENCE_MS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            throw new CancellationException("arrêté");
        }
    }

    /** Attend un peu après le brouillon : si le geste continue, il n'y a pas d'image à interrompre. */
    void attendreLaSuite() {
        try {
            Thread.sleep(GESTE_MS);
        } catch (InterruptedException e) {
            throw new CancellationException("arrêté");
        }
    }

    private void travailler() {
        if (aLire) {
            version = FichierScene.version(dessin.fichier);
            dessin.lire();
            lu = new Choix(dessin.fichier, dessin.getLue(), dessin.getLue(), dessin.getReglages(), null);
            choix = voulu == null ? lu : voulu.pour(lu, false);
            lue.countDown();
        }
        // une image de l'échelle est déjà dessinée
        if (!isCancelled() && !dessin.isBrouillonFait()) {
            if (voulu != null) {
                dessin.changer(choix.scene, choix.reglages);
            }
            // si l'image est bien plus grande que sa place, son brouillon est long
            if (dessin.largeur > Constantes.PAS_BROUILLON * place.width) {
                dessin.apercevoir(place.width, place.height, fils);
            }
            programme.accept(dessin);
        }
    }

    @Override
    protected Void doInBackground() {
        try {
            dessin.observer(this::travailler);
        } catch (RuntimeException | Error e) {
            echec = isCancelled() ? null : e;
        } finally {
            fin = System.nanoTime();
            lue.countDown();
        }
        return null;
    }

    void arreter() {
        cancel(true);
        fin = System.nanoTime();
    }

    /** Échec qui a arrêté ce dessin ; {@code null} s'il est en cours, achevé, ou arrêté sur demande. */
    Throwable getEchec() {
        return isDone() && !isCancelled() ? echec : null;
    }

    boolean isAcheve() {
        return isDone() && !isCancelled() && echec == null;
    }

    /** Le temps passé depuis la demande, en nanosecondes. */
    long getDureeNs() {
        return (fin != 0 ? fin : System.nanoTime()) - debut;
    }

    /** La part faite de l'image ou des étapes qui la précèdent, de 0 à 1. */
    double getAvancement() {
        return dessin.getLancer() == null || dessin.isBrouillonFait() ? dessin.getAvancement() : 0;
    }

    String getEtat() {
        // le résumé donne le temps du dessin seul ; ce temps compte aussi l'attente et la lecture
        return isAcheve() ? "terminé"
                : getEchec() instanceof SceneFautive ? aLire ? "scène refusée" : "réglage impossible"
                : (getEchec() != null ? "échec" : getEtape())
                + String.format(Locale.FRANCE, " — %.2f s", getDureeNs() / 1e9) + getReste();
    }

    private String getEtape() {
        String nom = dessin.getLancer() != null ? dessin.isBrouillonFait() ? "dessin" : "brouillon"
                : dessin.getLue() == null ? "lecture" : "préparation";
        if (!nom.equals(etape)) {
            etape = nom;
            debutEtapeNs = getDureeNs();
        }
        double part = dessin.getAvancement();
        if (isCancelled()) {
            return nom + " arrêté" + (dessin.getLancer() == null ? "e" : " à " + (int) (100 * part) + " %");
        }
        return nom + " " + (int) (100 * part) + " %";
    }

    /** Le temps qui reste à cette étape, d'après ce qui en est fait ; vide tant qu'il ne peut être estimé. */
    private String getReste() {
        double part = dessin.getAvancement();
        long passe = getDureeNs() - debutEtapeNs;
        double s = passe * (1 - part) / part / 1e9;
        String reste = s < 60 ? Math.round(s) + " s" : s < 3600 ? Math.round(s / 60) + " min"
                : Math.round(s / 3600) + " h";
        return isDone() || part == 0 || passe < RESTE_NS ? "" : ", reste " + reste;
    }
}
