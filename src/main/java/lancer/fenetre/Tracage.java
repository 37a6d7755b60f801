package lancer.fenetre;

import java.awt.Dimension;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingWorker;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.dessin.Dessin;
import lancer.dessin.Dessinateur;
import lancer.dessin.ReglagesDessin;
import lancer.scene.FichierScene;

/** Un dessin pour la fenêtre, loin du fil des événements : lire la scène s'il le faut, la préparer, la dessiner. */
final class Tracage extends SwingWorker<Void, Void> {

    /**
     * Temps après lequel un brouillon que rien ne montre n'arrête plus l'image, car une fenêtre peut être réduite ; et
     * un dessin qui n'a pas commencé dit ce qu'il attend.
     */
    private static final long PATIENCE_MS = 2000;

    /** Le fichier de la scène à lire, {@code null} s'il n'y en a pas. */
    final String fichier;
    /** La taille de l'image, en pixels. */
    final Dimension taille;
    private final Dessinateur dessinateur;
    private final ReglagesDessin voulus;
    private final long debut = System.nanoTime();
    /** La version de ce fichier qui est lue, ou dont la lecture a échoué. */
    volatile String version;
    /** Avertissements de la scène lue, et réglages de son dessin ; {@code null} tant qu'elle ne l'est pas. */
    volatile List<String> avertissements;
    volatile ReglagesDessin reglages;
    private volatile long fin;
    private volatile boolean dessine;
    private volatile Dessin dessin;
    private volatile Throwable panne;
    private final CountDownLatch lue = new CountDownLatch(1);
    /** Ouvert quand le brouillon se voit : la suite peut se dessiner. */
    final CountDownLatch vue = new CountDownLatch(1);

    /**
     * @param fichier {@code null} pour redessiner la scène qui est déjà lue
     * @param voulus ses réglages, {@code null} pour ceux de la ligne de commande et du fichier
     */
    Tracage(Dessinateur dessinateur, String fichier, Dimension taille, ReglagesDessin voulus) {
        this.dessinateur = dessinateur;
        this.fichier = fichier;
        this.taille = taille;
        this.voulus = voulus;
    }

    /** Attend que la scène soit lue, ou sa lecture abandonnée, tant de millisecondes au plus ; lance son refus. */
    void attendreLecture(long ms) {
        try {
            lue.await(ms, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            throw Echec.panne("interrompu");
        }
        if (avertissements == null && panne instanceof Error) {
            throw (Error) panne;
        }
        if (avertissements == null && panne != null) {
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

    @Override
    protected Void doInBackground() {
        try {
            if (fichier != null) {
                version = FichierScene.version(fichier);
                avertissements = dessinateur.lireScene(fichier);
                lue.countDown();
            }
            if (!isCancelled()) {
                if (voulus != null) {
                    dessinateur.regler(fichier == null ? voulus : voulus.pour(dessinateur.getReglages()));
                }
                reglages = dessinateur.getReglages();
                dessine = true;
                dessinateur.programme.doTracerImage(taille.width, taille.height);
            }
        } catch (RuntimeException | Error e) {
            panne = isCancelled() ? null : e;
        } finally {
            // le dessin d'après aura le sien
            dessin = getDessin();
            dessine = false;
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

    /** Vrai si l'image est entière. */
    boolean isAcheve() {
        return isDone() && !isCancelled() && panne == null;
    }

    /** L'image et ce qui la dessine ; {@code null} tant que la scène se lit et se prépare. */
    Dessin getDessin() {
        return dessine ? dessinateur.getDessin() : dessin;
    }

    /** Vrai si chaque pixel de l'image a une couleur. */
    boolean isBrouillonFait() {
        Dessin sien = getDessin();
        return sien != null && sien.traceur.isBrouillonFait();
    }

    /** Le temps passé depuis la demande, en nanosecondes. */
    long getDureeNs() {
        return (fin != 0 ? fin : System.nanoTime()) - debut;
    }

    /** La part faite de l'image, ou de ce qui la précède, de 0 à 1. */
    double getAvancement() {
        Dessin sien = getDessin();
        return sien == null ? dessinateur.getAvancement() : isBrouillonFait() ? sien.traceur.getAvancement() : 0;
    }

    /** État du dessin : où il en est, et depuis combien de temps. */
    String getEtat() {
        // le temps du dessin se lit avec ce qu'il a coûté ; celui-ci compte aussi l'attente et la lecture
        return isAcheve() ? "terminé"
                : getPanne() instanceof SceneFautive ? fichier == null ? "réglage impossible" : "scène refusée"
                : (getPanne() != null ? "échec" : getEtape())
                + String.format(Locale.FRANCE, " — %.2f s", getDureeNs() / 1e9);
    }

    private String getEtape() {
        Dessin sien = getDessin();
        if (getState() == StateValue.PENDING && TimeUnit.NANOSECONDS.toMillis(getDureeNs()) > PATIENCE_MS) {
            return "attend que le dessin d'avant s'arrête";
        }
        if (sien == null) {
            return (fichier != null && avertissements == null ? "lecture" : "préparation")
                    + (isCancelled() ? " arrêtée" : " " + (int) (100 * dessinateur.getAvancement()) + " %");
        }
        return (!isBrouillonFait() ? "brouillon " : isCancelled() ? "" : "dessin ")
                + (isCancelled() ? "arrêté à " : "") + (int) (100 * sien.traceur.getAvancement()) + " %";
    }
}
