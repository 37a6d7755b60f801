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
import lancer.dessin.ReglagesDessin;
import lancer.scene.FichierScene;

/** Un dessin pour la fenêtre, loin du fil des événements : lire la scène s'il le faut, la préparer, la dessiner. */
final class Tracage extends SwingWorker<Void, Void> {

    /** Temps après lequel un brouillon jamais vu n'arrête plus l'image, et un dessin à venir dit ce qu'il attend. */
    private static final long PATIENCE_MS = 2000;

    /** Temps laissé à un geste pour continuer. */
    private static final long GESTE_MS = 150;

    final Dessin dessin;
    final boolean aLire;
    private final Consumer<Dessin> programme;
    private final ReglagesDessin voulus;
    /** La taille où l'image sera montrée. */
    private final Dimension place;
    private final int fils;
    private final long debut = System.nanoTime();
    /** La version de ce fichier qui est lue, ou dont la lecture a échoué. */
    volatile String version;
    /** Vrai une fois dit que la scène est lue sans faute, et qu'un pixel est lent. */
    boolean lueDite;
    boolean lenteurDite;
    private volatile long fin;
    private volatile Throwable panne;
    private final CountDownLatch lue = new CountDownLatch(1);
    /** Ouvert quand le brouillon se voit : la suite peut se dessiner. */
    final CountDownLatch vue = new CountDownLatch(1);

    /**
     * @param voulus ses réglages, {@code null} pour ceux de la ligne de commande et du fichier
     * @param place la taille où l'image sera montrée, en pixels
     */
    Tracage(Consumer<Dessin> programme, Dessin dessin, ReglagesDessin voulus, Dimension place, int fils) {
        this.place = place;
        this.fils = fils;
        this.programme = programme;
        this.dessin = dessin;
        this.voulus = voulus;
        aLire = dessin.getLue() == null;
    }

    /** Attend que la scène soit lue, ou sa lecture abandonnée, tant de millisecondes au plus ; lance son refus. */
    void attendreLecture(long ms) {
        try {
            lue.await(ms, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            throw Echec.panne("interrompu");
        }
        if (dessin.getLue() == null && panne instanceof Error) {
            throw (Error) panne;
        }
        if (dessin.getLue() == null && panne != null) {
            throw (RuntimeException) panne;
        }
    }

    /** Attend que le brouillon se voie : la fenêtre qui s'ouvre a d'abord besoin de la machine. */
    void attendreDEtreVu() {
        try {
            vue.await(PATIENCE_MS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            throw new CancellationException("arrêté");
        }
    }

    /** Attend un moment, le brouillon fait : le geste qui continue n'aura pas d'image à interrompre. */
    void attendreLaSuite() {
        try {
            Thread.sleep(GESTE_MS);
        } catch (InterruptedException e) {
            throw new CancellationException("arrêté");
        }
    }

    @Override
    protected Void doInBackground() {
        try {
            if (aLire) {
                version = FichierScene.version(dessin.fichier);
                dessin.lire();
                lue.countDown();
            }
            if (!isCancelled()) {
                if (voulus != null) {
                    dessin.regler(aLire ? voulus.pour(dessin.getReglages()) : voulus);
                }
                // le brouillon d'une image bien plus grande que sa place se ferait attendre
                if (dessin.largeur > Constantes.PAS_BROUILLON * place.width) {
                    dessin.apercevoir(place.width, place.height, fils);
                }
                programme.accept(dessin);
            }
        } catch (RuntimeException | Error e) {
            panne = isCancelled() ? null : e;
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

    /** Panne qui a arrêté ce dessin ; {@code null} s'il est en cours, achevé, ou arrêté sur demande. */
    Throwable getPanne() {
        return isDone() && !isCancelled() ? panne : null;
    }

    boolean isAcheve() {
        return isDone() && !isCancelled() && panne == null;
    }

    /** Le temps passé depuis la demande, en nanosecondes. */
    long getDureeNs() {
        return (fin != 0 ? fin : System.nanoTime()) - debut;
    }

    /** La part faite de l'image, ou de ce qui la précède, de 0 à 1. */
    double getAvancement() {
        return dessin.getLancer() == null || dessin.isBrouillonFait() ? dessin.getAvancement() : 0;
    }

    String getEtat() {
        // le temps du dessin se lit avec ce qu'il a coûté ; celui-ci compte aussi l'attente et la lecture
        return isAcheve() ? "terminé"
                : getPanne() instanceof SceneFautive ? aLire ? "scène refusée" : "réglage impossible"
                : (getPanne() != null ? "échec" : getEtape())
                + String.format(Locale.FRANCE, " — %.2f s", getDureeNs() / 1e9);
    }

    private String getEtape() {
        if (getState() == StateValue.PENDING && TimeUnit.NANOSECONDS.toMillis(getDureeNs()) > PATIENCE_MS) {
            return "attend que le dessin d'avant s'arrête";
        }
        int part = (int) (100 * dessin.getAvancement());
        if (dessin.getLancer() == null) {
            return (dessin.getLue() == null ? "lecture" : "préparation")
                    + (isCancelled() ? " arrêtée" : " " + part + " %");
        }
        return (!dessin.isBrouillonFait() ? "brouillon " : isCancelled() ? "" : "dessin ")
                + (isCancelled() ? "arrêté à " : "") + part + " %";
    }
}
