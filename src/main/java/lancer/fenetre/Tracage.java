package lancer.fenetre;

import java.awt.Dimension;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import javax.swing.SwingWorker;
import lancer.Constantes;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Lecture;
import lancer.fils.Equipe;
import lancer.image.ImageMemoire;
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

    final String fichier;
    final boolean aLire;
    final int largeur;
    final int hauteur;
    private final Moteur moteur;
    /** Ce que la ligne de commande demande de la scène ; {@code null} avant la lecture. */
    volatile Demande initiale;
    /** Le dessin ; {@code null} avant la préparation. */
    volatile Dessin dessin;
    /** La petite image qui précède le brouillon, ou {@code null}. */
    private volatile ImageMemoire apercu;
    private volatile double partLue;
    private final String vueVoulue;
    private final ImageMemoire avant;
    Runnable entracte = () -> { };
    private final Choix voulu;
    /** La taille de l'image à l'écran. */
    private final Dimension place;
    private final long debut = System.nanoTime();
    /** La version du fichier lu, même si sa lecture a échoué. */
    volatile String version;
    /** Ce que dit ce fichier, sans aucun déplacement, puis ce qui est dessiné ; {@code null} avant sa lecture. */
    private volatile Choix lu;
    volatile Choix choix;
    /** Vrai quand la fenêtre a montré que la scène est lue. */
    boolean lueDite;
    private String etape;
    private long debutEtapeNs;
    private volatile long fin;
    private volatile Throwable echec;
    private final CountDownLatch lue = new CountDownLatch(1);
    /** Ouvert quand le brouillon est affiché : l'image peut se dessiner. */
    final CountDownLatch vue = new CountDownLatch(1);

    /** Ce qui lit et dessine pour la fenêtre. */
    static final class Moteur {

        final Options options;
        final BiFunction<String, DoubleConsumer, Lecture> lecteur;
        final BiConsumer<Demande, Consumer<Dessin>> programme;

        Moteur(Options options, BiFunction<String, DoubleConsumer, Lecture> lecteur,
                BiConsumer<Demande, Consumer<Dessin>> programme) {
            this.options = options;
            this.lecteur = lecteur;
            this.programme = programme;
        }
    }

    /**
     * @param initiale ce que la ligne de commande demande de la scène ; {@code null} pour la lire
     * @param voulu ce qui est choisi, {@code null} pour ce que disent la ligne de commande et le fichier
     * @param avant l'image à laquelle une vue se compare, ou {@code null}
     * @param taille celle de l'image @param place la taille de l'image à l'écran, en pixels
     */
    Tracage(Moteur moteur, String fichier, Demande initiale, Choix voulu, ImageMemoire avant, Dimension taille,
            Dimension place) {
        this.moteur = moteur;
        this.fichier = fichier;
        this.initiale = initiale;
        this.voulu = voulu;
        this.place = place;
        largeur = taille.width;
        hauteur = taille.height;
        vueVoulue = voulu == null ? null : voulu.vue;
        this.avant = avant != null && avant.largeur == largeur && avant.hauteur == hauteur ? avant : null;
        aLire = initiale == null;
        choix = aLire ? null : voulu;
    }

    /** Un tracé dont l'image est déjà dessinée. */
    Tracage(Moteur moteur, Demande initiale, Choix voulu, Dessin dessine) {
        this(moteur, initiale.lecture.fichier, initiale, voulu, null,
                new Dimension(dessine.demande.largeur, dessine.demande.hauteur), null);
        dessin = dessine;
    }

    /** La petite image qui précède le brouillon ; {@code null} si elle n'existe pas ou si le brouillon est fini. */
    ImageMemoire getApercu() {
        return isBrouillonFait() ? null : apercu;
    }

    boolean isBrouillonFait() {
        return dessin != null && dessin.isBrouillonFait();
    }

    Choix getLu() {
        return lu;
    }

    /** La scène lue par ce dessin, telle qu'elle est dans son fichier. */
    SceneLue getLue() {
        return lu.lue;
    }

    boolean litLaSceneDe(Tracage autre) {
        return autre != null && fichier.equals(autre.fichier);
    }

    /** Attend la fin ou l'échec de la lecture, {@code ms} millisecondes au plus ; lève l'exception de l'échec. */
    void attendreLecture(long ms) {
        try {
            lue.await(ms, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            throw Echec.machine("interrompu");
        }
        if (initiale == null && echec instanceof Error) {
            throw (Error) echec;
        } else if (initiale == null && echec != null) {
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
            version = FichierScene.version(fichier);
            Lecture lecture = moteur.lecteur.apply(fichier, part -> partLue = part);
            Demande demande = new Demande(lecture, moteur.options);
            lu = new Choix(fichier, lecture.lue, lecture.lue, demande.reglages, null);
            choix = voulu == null ? lu : voulu.pour(lu, false);
            initiale = demande;
            lue.countDown();
        }
        // une image de l'échelle est déjà dessinée
        if (!isCancelled() && dessin == null) {
            tracer();
        }
    }

    private void tracer() {
        Lecture lecture = initiale.lecture;
        Demande demande = initiale.avecLecture(choix.scene == lecture.lue ? lecture
                : new Lecture(fichier, choix.scene, 0)).avecReglages(choix.reglages).avecTaille(largeur, hauteur)
                .avecVue(vueVoulue);
        // si l'image est bien plus grande que sa place, son brouillon est long
        if (largeur > Constantes.PAS_BROUILLON * place.width) {
            Dessin petit = new Dessin(demande.avecTaille(place.width, place.height));
            petit.lancer.getFautes().tolerer();
            petit.lancer.TracerPixels(null, petit.image, Math.min(demande.reglages.getProfondeur(),
                    Constantes.REFLETS_BROUILLON), moteur.options.fils);
            apercu = petit.image;
        }
        if (demande.vue == null) {
            moteur.programme.accept(demande, this::suivre);
        } else {
            dessin = new Dessin(demande);
            dessin.dessinerLaVue(avant, moteur.options.fils, entracte);
        }
    }

    private void suivre(Dessin sien) {
        dessin = sien;
        if (sien.isBrouillonFait()) {
            entracte.run();
        }
    }

    @Override
    protected Void doInBackground() {
        try {
            new Equipe("dessin").faire(this::travailler);
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
        return dessin == null || isBrouillonFait() ? getPart() : 0;
    }

    /** La part faite de l'étape en cours, de 0 à 1. */
    private double getPart() {
        return dessin != null ? dessin.lancer.getAvancement() : initiale == null ? partLue : 0;
    }

    String getEtat() {
        // le résumé donne le temps du dessin seul ; ce temps compte aussi l'attente et la lecture
        return isAcheve() ? "terminé"
                : getEchec() instanceof SceneFautive ? aLire ? "scène refusée" : "réglage impossible"
                : (getEchec() != null ? "échec" : getEtape())
                + String.format(Locale.FRANCE, " — %.2f s", getDureeNs() / 1e9) + getReste();
    }

    private String getEtape() {
        String nom = dessin != null ? isBrouillonFait() ? "dessin" : "brouillon"
                : initiale == null ? "lecture" : "préparation";
        if (!nom.equals(etape)) {
            etape = nom;
            debutEtapeNs = getDureeNs();
        }
        double part = getPart();
        if (isCancelled()) {
            return nom + " arrêté" + (dessin == null ? "e" : " à " + (int) (100 * part) + " %");
        }
        return nom + " " + (int) (100 * part) + " %";
    }

    /** Le temps qui reste à cette étape, d'après ce qui en est fait ; vide tant qu'il ne peut être estimé. */
    private String getReste() {
        double part = getPart();
        long passe = getDureeNs() - debutEtapeNs;
        double s = passe * (1 - part) / part / 1e9;
        String reste = s < 60 ? Math.round(s) + " s" : s < 3600 ? Math.round(s / 60) + " min"
                : Math.round(s / 3600) + " h";
        return isDone() || part == 0 || passe < RESTE_NS ? "" : ", reste " + reste;
    }
}
