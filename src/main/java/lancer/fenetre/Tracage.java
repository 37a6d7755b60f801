package lancer.fenetre;

import java.awt.Dimension;
import java.io.PrintStream;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;
import lancer.Lancer;
import lancer.Main;
import lancer.SceneFautive;

/** Un dessin pour la fenêtre, loin du fil des événements : lire la scène s'il le faut, la préparer, la dessiner. */
final class Tracage extends SwingWorker<Void, Void> {

    private static final double NS_PAR_S = 1e9;

    private final Main main;
    private final String aLire;
    private final Dimension taille;
    private final Surveillance surveillance;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private Consumer<Tracage> suite;
    private boolean rendu;
    private final long debut = System.nanoTime();
    private volatile long fin;
    private volatile boolean lu;
    private volatile boolean dessine;
    private boolean lectureVue;

    /**
     * @param aLire la scène à lire, {@code null} pour redessiner celle qui est déjà lue
     * @param taille celle de l'image, en pixels
     */
    Tracage(Main main, String aLire, Dimension taille, Surveillance surveillance, PrintStream sortie,
            PrintStream erreur) {
        this.main = main;
        this.aLire = aLire;
        this.taille = taille;
        this.surveillance = surveillance;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    Dimension getTaille() {
        return taille;
    }

    /**
     * À appeler sur le fil des événements.
     *
     * @param suite appelée sur ce fil quand c'est achevé, arrêté ou manqué
     */
    void ensuite(Consumer<Tracage> suite) {
        this.suite = suite;
        if (rendu) {
            suite.accept(this);
        }
    }

    @Override
    protected Void doInBackground() {
        try {
            if (aLire != null) {
                surveillance.suivre(aLire);
                main.lireScene(aLire);
                lu = true;
            }
            if (isCancelled()) {
                return null;
            }
            dessine = true;
            main.doTracerImage(taille.width, taille.height);
        } finally {
            fin = System.nanoTime();
        }
        Main.direEcart(main.getLancer(), erreur);
        if (main.getOptions().statistiques && !isCancelled()) {
            sortie.println(main.getStatistiques());
            sortie.flush();
        }
        return null;
    }

    @Override
    protected void done() {
        if (fin == 0) {
            fin = System.nanoTime();
        }
        rendu = true;
        if (suite != null) {
            suite.accept(this);
        }
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
        return dessine ? main.getLancer() : null;
    }

    /** Vrai si la scène à lire ne l'est pas encore : à refaire si l'on interrompt ce dessin. */
    boolean resteALire() {
        return aLire != null && !lu && (isCancelled() || !isDone());
    }

    /** Vrai une seule fois, quand la scène vient d'être lue. */
    boolean vientDeLire() {
        if (!lu || lectureVue) {
            return false;
        }
        lectureVue = true;
        return true;
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
        return etape() + String.format(Locale.FRANCE, " — %.2f s", getDureeNs() / NS_PAR_S);
    }

    private String etape() {
        Lancer lancer = getLancer();
        if (isCancelled()) {
            return "arrêté à " + pourCent();
        }
        if (isDone()) {
            return getPanne() == null ? "terminé" : "échec";
        }
        if (lancer == null) {
            return aLire != null && !lu ? "lecture…" : "préparation…";
        }
        return lancer.isBrouillonFait() ? "dessin " + pourCent() : "brouillon " + pourCent(lancer.getAvancement());
    }

    private String pourCent() {
        return pourCent(getAvancement());
    }

    private static String pourCent(double part) {
        return (int) (100 * part) + " %";
    }
}
