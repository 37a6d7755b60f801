package lancer.fenetre;

import java.awt.Dimension;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import javax.swing.SwingWorker;
import lancer.Lancer;
import lancer.Scene;
import lancer.SceneFautive;

/** Un dessin pour la fenêtre, loin du fil des événements : lire la scène s'il le faut, la préparer, la dessiner. */
final class Tracage extends SwingWorker<Void, Void> {

    private static final double NS_PAR_S = 1e9;

    private final Dessinateur dessinateur;
    private final String aLire;
    private final Dimension taille;
    private final Surveillance surveillance;
    private final long debut = System.nanoTime();
    private volatile long fin;
    private volatile Scene lue;
    private volatile boolean dessine;

    /**
     * @param aLire la scène à lire, {@code null} pour redessiner celle qui est déjà lue
     * @param taille celle de l'image, en pixels
     */
    Tracage(Dessinateur dessinateur, String aLire, Dimension taille, Surveillance surveillance) {
        this.dessinateur = dessinateur;
        this.aLire = aLire;
        this.taille = taille;
        this.surveillance = surveillance;
    }

    Dimension getTaille() {
        return taille;
    }

    @Override
    protected Void doInBackground() {
        try {
            if (aLire != null) {
                surveillance.suivre(aLire);
                lue = dessinateur.lireScene(aLire);
            }
            if (!isCancelled()) {
                dessine = true;
                dessinateur.doTracerImage(taille.width, taille.height);
            }
            return null;
        } finally {
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

    /** Ce qui dessine ; {@code null} tant que la scène se lit et se prépare. */
    Lancer getLancer() {
        return dessine ? dessinateur.getLancer() : null;
    }

    /** La scène que ce dessin a lue ; {@code null} s'il n'en avait pas à lire, ou ne l'a pas encore lue. */
    Scene getLue() {
        return lue;
    }

    /** Vrai si la scène à lire ne l'est pas encore : à refaire si l'on interrompt ce dessin. */
    boolean resteALire() {
        return aLire != null && lue == null && getPanne() == null;
    }

    /** Le temps passé depuis la demande, en nanosecondes. */
    long getDureeNs() {
        return (fin != 0 ? fin : System.nanoTime()) - debut;
    }

    /** La part faite de l'image, de 0 à 1. */
    double getAvancement() {
        Lancer lancer = getLancer();
        return lancer == null || !lancer.isBrouillonFait() ? 0 : lancer.getAvancement();
    }

    /** Où il en est, et depuis combien de temps. */
    String getEtat() {
        if (getPanne() instanceof SceneFautive) {
            return "scène fautive";
        }
        return getEtape() + String.format(Locale.FRANCE, " — %.2f s", getDureeNs() / NS_PAR_S);
    }

    private String getEtape() {
        Lancer lancer = getLancer();
        if (isCancelled()) {
            return "arrêté à " + pourCent(getAvancement());
        }
        if (isDone()) {
            return getPanne() == null ? "terminé" : "échec";
        }
        if (lancer == null) {
            return aLire != null && lue == null ? "lecture…" : "préparation…";
        }
        return (lancer.isBrouillonFait() ? "dessin " : "brouillon ") + pourCent(lancer.getAvancement());
    }

    private static String pourCent(double part) {
        return (int) (100 * part) + " %";
    }
}
