package lancer.fenetre;

import java.awt.Dimension;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingWorker;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.dessin.Dessin;
import lancer.dessin.Dessinateur;
import lancer.dessin.ReglagesDessin;
import lancer.fils.Traceur;

/** Un dessin pour la fenêtre, loin du fil des événements : lire la scène s'il le faut, la préparer, la dessiner. */
final class Tracage extends SwingWorker<Void, Void> {

    private static final double NS_PAR_S = 1e9;

    private final Dessinateur dessinateur;
    /** Le fichier de la scène à lire, {@code null} s'il n'y en a pas. */
    final String fichier;
    /** La taille de l'image, en pixels. */
    final Dimension taille;
    private final ReglagesDessin voulus;
    private final long debut = System.nanoTime();
    private volatile long fin;
    private volatile String version;
    private volatile List<String> avertissements;
    private volatile ReglagesDessin reglages;
    private volatile boolean dessine;
    private volatile Dessin dessin;
    private final CountDownLatch lue = new CountDownLatch(1);
    private volatile Throwable refus;

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

    /** Lit la scène, dans le fil de l'appelant. */
    void lire() {
        version = Surveillance.version(fichier);
        try {
            avertissements = dessinateur.lireScene(fichier);
        } catch (RuntimeException | Error e) {
            refus = e;
            throw e;
        } finally {
            lue.countDown();
        }
    }

    /**
     * Attend que la scène soit lue, ou sa lecture abandonnée, tant de millisecondes au plus.
     *
     * @throws SceneFautive si elle ne peut être utilisée
     */
    void attendreLecture(long ms) {
        try {
            lue.await(ms, TimeUnit.MILLISECONDS);
            if (refus instanceof Error) {
                throw (Error) refus;
            }
            if (refus != null && !(refus instanceof CancellationException)) {
                throw (RuntimeException) refus;
            }
        } catch (InterruptedException e) {
            throw Echec.panne("interrompu");
        }
    }

    @Override
    protected Void doInBackground() {
        try {
            if (resteALire()) {
                lire();
            }
            if (!isCancelled()) {
                if (voulus != null) {
                    dessinateur.regler(fichier == null ? voulus : voulus.pour(dessinateur.getReglages()));
                }
                reglages = dessinateur.getReglages();
                dessine = true;
                dessinateur.doTracerImage(taille.width, taille.height);
            }
            return null;
        } finally {
            // le dessin d'après aura le sien
            dessin = dessine ? dessinateur.getDessin() : null;
            dessine = false;
            fin = System.nanoTime();
        }
    }

    void arreter() {
        cancel(true);
        fin = System.nanoTime();
    }

    /** Vrai s'il n'y a plus rien à en attendre ; arrêté, son fil peut finir un peu plus tard. */
    boolean isFini() {
        return isCancelled() || isDone();
    }

    /** Ce qui a empêché ce dessin d'aller au bout ; {@code null} s'il est en cours, achevé, ou arrêté sur demande. */
    Throwable getPanne() {
        if (isCancelled() || !isDone()) {
            return null;
        }
        try {
            get();
            return null;
        } catch (ExecutionException e) {
            return e.getCause();
        } catch (InterruptedException e) {
            return e;
        }
    }

    /** Vrai si l'image est entière. */
    boolean isAcheve() {
        return isDone() && !isCancelled() && getPanne() == null;
    }

    /** L'image et ce qui la dessine ; {@code null} tant que la scène se lit et se prépare. */
    Dessin getDessin() {
        return dessine ? dessinateur.getDessin() : dessin;
    }

    private Traceur getTraceur() {
        Dessin sien = getDessin();
        return sien == null ? null : sien.traceur;
    }

    /** Vrai si chaque pixel de l'image a une couleur. */
    boolean isBrouillonFait() {
        Traceur lancer = getTraceur();
        return lancer != null && lancer.isBrouillonFait();
    }

    /** La version de ce fichier qui est lue, ou dont la lecture a échoué. */
    String getVersion() {
        return version;
    }

    /** Ceux de la scène lue, {@code null} tant qu'elle ne l'est pas. */
    List<String> getAvertissements() {
        return avertissements;
    }

    /** Ceux avec lesquels il se dessine, {@code null} tant que la scène n'est pas lue. */
    ReglagesDessin getReglages() {
        return reglages;
    }

    private boolean resteALire() {
        return fichier != null && avertissements == null;
    }

    /** Le temps passé depuis la demande, en nanosecondes. */
    long getDureeNs() {
        return (fin != 0 ? fin : System.nanoTime()) - debut;
    }

    /** La part faite de l'image, de 0 à 1. */
    double getAvancement() {
        Traceur lancer = getTraceur();
        return lancer == null ? dessinateur.getAvancement() : lancer.isBrouillonFait() ? lancer.getAvancement() : 0;
    }

    /** Où il en est, et depuis combien de temps. */
    String getEtat() {
        if (getPanne() instanceof SceneFautive) {
            return fichier == null ? "réglage impossible" : "scène fautive";
        }
        // achevé, le temps du dessin se lit avec ce qu'il a coûté ; celui-ci compte aussi l'attente et la lecture
        return isAcheve() ? "terminé" : getEtape() + String.format(Locale.FRANCE, " — %.2f s", getDureeNs() / NS_PAR_S);
    }

    private String getEtape() {
        Traceur lancer = getTraceur();
        if (getPanne() != null) {
            return "échec";
        }
        if (lancer == null) {
            return (resteALire() ? "lecture" : "préparation")
                    + (isCancelled() ? " arrêtée" : " " + (int) (100 * dessinateur.getAvancement()) + " %");
        }
        return (lancer.isBrouillonFait() ? isCancelled() ? "" : "dessin " : "brouillon ")
                + (isCancelled() ? "arrêté à " : "") + (int) (100 * lancer.getAvancement()) + " %";
    }
}
