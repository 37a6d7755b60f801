package lancer.fenetre;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.io.File;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.fenetre.Bandeau.Sujet;
import lancer.fils.Fautes;
import lancer.image.ImageMemoire;
import lancer.scene.Surveillance;

/**
 * Suite des dessins de la fenêtre : début, fin, arrêt, échec. La scène montrée reste la même jusqu'à la première image
 * d'une autre scène. {@link Tracage} calcule dans un autre fil ; tout est appelé ici dans le fil des événements.
 */
final class Controleur {

    /** Durée, en nanosecondes, avant de montrer une partie du brouillon. */
    private static final long PATIENCE_NS = 300_000_000;
    /** Temps maximal entre deux touches, ou deux crans, d'un même geste. */
    private static final long GESTE_NS = 1_000_000_000;

    final int fils;
    private final Tracage.Moteur moteur;
    private final ExecutorService dessins;
    final PanneauImage panneau;
    private final Supplier<Dimension> taille;
    private final Surveillance surveillance;
    private final List<Runnable> prevenus = new ArrayList<>();
    private Object geste;
    private long gesteNs;

    /** Lu par toute la fenêtre, et remplacé ici seulement. */
    Etat etat = Etat.VIDE;

    /** @param moteur ce qui lit et dessine, dans le fil des dessins */
    Controleur(Tracage.Moteur moteur, ExecutorService dessins, PanneauImage panneau, Supplier<Dimension> taille) {
        this.moteur = moteur;
        this.dessins = dessins;
        fils = moteur.options.fils;
        this.panneau = panneau;
        this.taille = taille;
        surveillance = new Surveillance(() -> EventQueue.invokeLater(this::relire),
                () -> EventQueue.invokeLater(this::direEfface));
    }

    /** Un fil unique, où les tâches attendent leur tour. Il se termine quand il n'a plus de tâche. */
    static ExecutorService unFil(String nom) {
        ThreadPoolExecutor seul = new ThreadPoolExecutor(1, 1, 1, TimeUnit.SECONDS, new LinkedBlockingQueue<>(),
                tache -> {
                    Thread fil = new Thread(tache, nom);
                    fil.setDaemon(true);
                    return fil;
                });
        seul.allowCoreThreadTimeOut(true);
        return seul;
    }

    /** Confie une tâche à ce fil. Si elle échoue, {@code siEchec} reçoit le message, dans le fil des événements. */
    static Future<?> confier(ExecutorService fil, Runnable tache, Consumer<String> siEchec) {
        return fil.submit(() -> {
            try {
                tache.run();
            } catch (CancellationException e) {
                // le résultat de cette tâche n'est plus demandé
            } catch (RuntimeException | Error e) {
                EventQueue.invokeLater(() -> siEchec.accept(Messages.message(e)));
            }
        });
    }

    /** Appelle {@code siChange} quand un dessin commence, s'achève ou s'arrête, et quand une scène est lue. */
    void prevenir(Runnable siChange) {
        prevenus.add(siChange);
    }

    void avertir() {
        prevenus.forEach(Runnable::run);
    }

    private void poser(Etat suivant) {
        etat = suivant;
        avertir();
    }

    /** La commande qui dessine la scène montrée ainsi, si ses sections changées sont mises dans le fichier. */
    String getCommande() {
        return Messages.commande("", etat.getReglages().getOptions(), etat.lecture.fichier, taille.get().width,
                taille.get().height);
    }

    void commencer(Tracage tracage) {
        etat = etat.demander(tracage.fichier).commencer(tracage);
        if (tracage.choix != null) {
            adopter();
        }
        suivre(tracage);
    }

    /** Lit cette scène et la dessine ; le dessin en cours est abandonné. */
    void ouvrir(String scene) {
        etat = etat.demander(scene);
        lancer(tracer(scene, null), false);
    }

    void relire() {
        ouvrir(etat.demande);
    }

    void dessiner(Reglages voulus) {
        choisir(etat.choix.avec(voulus));
    }

    void choisir(Choix voulu) {
        choisir(voulu, null, false);
    }

    /** @param cause ce qui change : le geste continue si c'était déjà cela @param tenu vrai si un bouton est tenu */
    void choisir(Choix voulu, Object cause, boolean tenu) {
        boolean suite = cause != null && cause == geste && (tenu || System.nanoTime() - gesteNs < GESTE_NS);
        geste = cause;
        gesteNs = System.nanoTime();
        etat = etat.choisir(voulu, suite);
        if (suite && etat.enCours && !etat.lit() && !etat.courant.isBrouillonFait()) {
            // le geste continue : le brouillon en cours est d'abord montré
            avertir();
        } else {
            redessiner(suite);
        }
    }

    /** Montre cette image, déjà dessinée. */
    void montrer(Dessin dessine) {
        etat = etat.choisir(etat.choix.avec(dessine.demande.reglages).avec((String) null), false);
        lancer(new Tracage(moteur, etat.lecture.initiale, etat.choix, dessine), false);
    }

    /** Défait le dernier choix ({@code sens} −1), ou le refait (1). */
    void revenir(int sens) {
        geste = null;
        etat = etat.revenir(sens);
        redessiner(false);
    }

    void ajuster() {
        Dimension voulue = taille.get();
        if (etat.lecture != null && (voulue.width != etat.courant.largeur || voulue.height != etat.courant.hauteur)) {
            redessiner(false);
        }
    }

    void arreter() {
        if (etat.enCours) {
            etat.courant.arreter();
            observer();
        }
    }

    void terminer() {
        if (etat.courant != null) {
            etat.courant.arreter();
        }
        surveillance.terminer();
        dessins.shutdown();
    }

    private void redessiner(boolean geste) {
        // une scène en cours de lecture passe avant la scène montrée
        if (etat.lit()) {
            relire();
        } else {
            lancer(tracer(etat.lecture.fichier, etat.lecture.initiale), geste);
        }
    }

    private Tracage tracer(String scene, Demande initiale) {
        Dimension voulue = taille.get();
        return new Tracage(moteur, scene, initiale, etat.choix, etat.avant, voulue,
                panneau.getTailleMax(voulue.width, voulue.height));
    }

    /** @param geste vrai si le geste peut continuer : l'image attend alors un peu après le brouillon */
    private void lancer(Tracage tracage, boolean geste) {
        if (dessins.isShutdown()) {
            return;
        }
        if (etat.courant != null) {
            etat.courant.arreter();
        }
        if (geste) {
            tracage.entracte = () -> {
                EventQueue.invokeLater(this::observer);
                tracage.attendreLaSuite();
            };
        }
        dessins.execute(tracage);
        suivre(tracage);
    }

    private void suivre(Tracage tracage) {
        panneau.dire("");
        poser(etat.commencer(tracage));
        observer();
    }

    /** Lit l'état du dessin en cours et le montre ; à appeler souvent. */
    void observer() {
        Tracage courant = etat.courant;
        Dessin dessin = courant.dessin;
        boolean fini = courant.isDone();
        if (panneau.peinte) {
            courant.vue.countDown();
        }
        if (courant.aLire && !courant.lueDite && (courant.choix != null
                || fini && (courant.version != null || courant.getEchec() != null))) {
            courant.lueDite = true;
            surveillance.suivre(etat.demande, courant.version);
            if (courant.choix != null) {
                // la scène n'a plus de faute, même si son image n'est pas encore montrée
                panneau.bandeau.dire(Sujet.SCENE, "");
            }
        }
        ImageMemoire image = dessin == null ? null : dessin.image;
        if (image != null && (image == panneau.montree || courant.isBrouillonFait()
                // sans image, une partie du brouillon est montrée
                || panneau.montree == null && (fini || courant.getDureeNs() > PATIENCE_NS))) {
            panneau.montree = image;
            panneau.repaint();
            if (etat.montre != dessin) {
                adopter();
                poser(etat.montrer());
            }
        }
        if (panneau.apercu != courant.getApercu()) {
            panneau.apercu = courant.getApercu();
            panneau.repaint();
        }
        if (fini && etat.enCours) {
            finir();
        }
        // le geste a continué pendant le brouillon
        if (courant == etat.courant && courant.choix != null && etat.choix != null
                && courant.choix.lue == etat.choix.lue && courant.choix != etat.choix
                && (fini || courant.isBrouillonFait())) {
            redessiner(true);
        }
    }

    /** Si ce dessin a lu une scène, elle devient la scène montrée. */
    private void adopter() {
        Tracage courant = etat.courant;
        if (!courant.aLire || courant == etat.lecture) {
            return;
        }
        List<String> avis = new ArrayList<>(courant.getLue().avertissements);
        boolean defait = courant.litLaSceneDe(etat.lecture) && !courant.choix.scene.getChanges(
                etat.choix.pour(courant.getLu(), true).scene).isEmpty();
        if (defait) {
            avis.add("scène relue : son fichier a changé la place de ce qui était déplacé ;"
                    + " Ctrl+Z le déplace de nouveau");
        }
        panneau.bandeau.dire(Sujet.DESSIN, "");
        panneau.bandeau.dire(Sujet.AVIS, String.join("\n", avis));
        etat = etat.adopter(defait);
    }

    private void finir() {
        Tracage courant = etat.courant;
        courant.vue.countDown();
        Throwable echec = courant.getEchec();
        Fautes fautes = courant.dessin == null ? null : courant.dessin.lancer.getFautes();
        if (courant.isAcheve()) {
            Dessin fait = courant.dessin;
            // les sections ignorées, sans le reste de leur avertissement
            String ignorees = String.join("\n", fait.demande.lecture.lue.avertissements)
                    .replaceAll(".*, ligne \\d+, (\\[[^]]*]).*\n?", ", $1 ignorée");
            panneau.legendes.put(fait.image, fait.getCout() + ", " + fait.demande.reglages + ignorees
                    + (fautes.enMots() == null ? "" : ", " + fautes.enMots()));
            if (fait.getEcart() != null) {
                panneau.bandeau.dire(Sujet.AVIS, fait.getEcart());
            }
        }
        poser(etat.finir());
        if (echec instanceof SceneFautive && courant.aLire) {
            refuser(Messages.message(echec));
        } else if (fautes != null && fautes.enMots() != null && !(echec instanceof Error)) {
            panneau.bandeau.dire(Sujet.DESSIN, fautes.enMots() + " ; le premier : "
                    + courant.dessin.demande.nommer(fautes.getPremiere()).getMessage());
        } else if (echec != null || courant.isAcheve()) {
            panneau.bandeau.dire(Sujet.DESSIN, echec == null ? "" : Messages.message(echec));
        }
        if (etat.montre == null && !etat.enCours) {
            panneau.dire("F5 pour lire la scène et la dessiner");
        }
    }

    /** Phrase qui donne le nombre de pixels fautifs de l'image montrée ; {@code null} s'il n'y en a pas. */
    String direFautes() {
        return etat.montre == null ? null : etat.montre.lancer.getFautes().enMots();
    }

    /** Dit la faute de la scène demandée, et de quelle scène est l'image qui reste. */
    private void refuser(String message) {
        boolean autre = etat.lecture != null && !etat.courant.litLaSceneDe(etat.lecture);
        panneau.bandeau.dire(Sujet.SCENE, message + (autre ? "\nl'image qui reste est celle de "
                + new File(etat.lecture.fichier).getName() : ""));
        if (etat.lecture != null && etat.getImageEntiere() == null) {
            // la faute a interrompu le dessin de la scène d'avant : il est repris
            redessiner(false);
        }
    }

    private void direEfface() {
        if (etat.lecture != null && etat.lecture.fichier.equals(etat.demande)) {
            panneau.bandeau.dire(Sujet.SCENE, "fichier effacé : la dernière image reste");
        }
    }
}
