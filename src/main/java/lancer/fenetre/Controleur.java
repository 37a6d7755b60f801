package lancer.fenetre;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
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
import lancer.commande.Pannes;
import lancer.dessin.Dessin;
import lancer.dessin.ReglagesDessin;
import lancer.fenetre.Bandeau.Sujet;
import lancer.fils.Fautes;
import lancer.image.ImageMemoire;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;

/**
 * Suite des dessins de la fenêtre : début, fin, arrêt, panne. La scène montrée reste la même jusqu'à la première image
 * d'une autre scène. {@link Tracage} calcule dans un autre fil ; tout est appelé ici dans le fil des événements.
 */
final class Controleur {

    /** Durée, en nanosecondes, avant de montrer une partie du brouillon ; plus grande image « avant » gardée. */
    private static final long PATIENCE_NS = 300_000_000;
    private static final int PIXELS_GARDES = 16_000_000;

    final int fils;
    private final Dessin premier;
    private final Consumer<Dessin> programme;
    private final ExecutorService dessins;
    final PanneauImage panneau;
    private final Supplier<Dimension> taille;
    private final Surveillance surveillance;
    private final List<Runnable> prevenus = new ArrayList<>();

    // ces champs sont lus par toute la fenêtre, et modifiés ici seulement
    /** Le fichier du titre et de la surveillance : celui de la scène montrée ou, à défaut, de la première. */
    String fichier;
    /** Le dernier dessin commencé, et le premier dessin de la scène montrée, ou {@code null}. */
    Tracage courant;
    Tracage adopte;
    /** Les réglages de la scène montrée, même si son dessin n'est pas achevé ; {@code null} avant la première. */
    ReglagesDessin reglages;
    /** Vrai pendant un dessin, lecture et préparation comprises, jusqu'à l'appel de {@link #finir}. */
    boolean enCours;
    /** Le dessin dont l'image ou le brouillon est montré : celui que l'on inspecte et que l'on enregistre. */
    Dessin montre;
    /** La scène montrée, avec les déplacements ; {@code null} avant la première. */
    Dessin source;
    /** La vue en fausses couleurs montrée à la place de l'image, ou {@code null}. */
    String vue;
    /** L'image achevée avant le dernier geste ; {@code null} s'il n'y en a pas, ou si elle est trop grande. */
    ImageMemoire avant;

    private final Deque<Dessin> avantDeplacements = new ArrayDeque<>();
    private ImageMemoire complete;
    /** Vrai si de nouveaux réglages attendent la fin du brouillon en cours. */
    private boolean enAttente;

    /** @param premier modèle des dessins d'autres scènes @param programme exécute un dessin, dans le fil des dessins */
    Controleur(Dessin premier, Consumer<Dessin> programme, ExecutorService dessins, int fils, PanneauImage panneau,
            Supplier<Dimension> taille) {
        this.premier = premier;
        this.programme = programme;
        this.dessins = dessins;
        this.fils = fils;
        this.panneau = panneau;
        this.taille = taille;
        surveillance = new Surveillance(() -> EventQueue.invokeLater(this::suivreFichier), () -> EventQueue.invokeLater(
                () -> panneau.bandeau.dire(Sujet.SCENE, "fichier effacé : la dernière image reste")));
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

    /** Confie une tâche à ce fil. Si elle échoue, {@code siPanne} reçoit le message, dans le fil des événements. */
    static Future<?> confier(ExecutorService fil, Runnable tache, Consumer<String> siPanne) {
        return fil.submit(() -> {
            try {
                tache.run();
            } catch (CancellationException e) {
                // le résultat de cette tâche n'est plus demandé
            } catch (RuntimeException | Error e) {
                EventQueue.invokeLater(() -> siPanne.accept(Pannes.message(e)));
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

    /** La commande qui dessine la scène montrée ainsi, si ses sections changées sont mises dans le fichier. */
    String getCommande() {
        return Pannes.commande("", reglages.getOptions(), fichier, taille.get().width, taille.get().height);
    }

    /** L'image montrée si elle est achevée, même si un autre dessin est commencé ; {@code null} sinon. */
    ImageMemoire getImageComplete() {
        return complete == panneau.montree ? complete : null;
    }

    void commencer(Tracage tracage) {
        courant = tracage;
        if (tracage.dessin.getLue() != null) {
            adopter();
        }
        suivre(tracage);
    }

    /** Lit cette scène et la dessine ; le dessin en cours est abandonné. */
    void ouvrir(String scene) {
        retenir();
        lancer(premier.pour(scene, taille.get().width, taille.get().height), false);
    }

    void relire() {
        ouvrir(fichier);
    }

    /** Relit la scène montrée, dont le fichier a changé, sauf si une autre scène est en cours de lecture. */
    private void suivreFichier() {
        if (!enCours || !courant.aLire || courant.dessin.fichier.equals(fichier)) {
            relire();
        }
    }

    /** Dessine la scène montrée avec ces réglages. @param suite vrai si le geste continue : « avant » ne change pas */
    void dessiner(ReglagesDessin voulus, boolean suite) {
        reglages = voulus;
        if (!suite) {
            retenir();
        }
        if (suite && enCours && !courant.dessin.isBrouillonFait()) {
            enAttente = true;
        } else {
            redessiner(suite);
        }
    }

    /** Montre cette vue en fausses couleurs. @param voulue {@code null} pour l'image */
    void voir(String voulue) {
        vue = voulue;
        redessiner(false);
    }

    /** Dessine cette autre version de la scène, en mémoire seulement. @param suite vrai si le geste continue */
    void changer(SceneLue nouvelle, boolean suite) {
        if (!suite) {
            avantDeplacements.push(source);
        }
        source = source.avec(nouvelle);
        dessiner(reglages, suite);
    }

    void defaire() {
        if (estDeplacee()) {
            source = avantDeplacements.pop();
            dessiner(reglages, false);
        }
    }

    boolean estDeplacee() {
        return !avantDeplacements.isEmpty();
    }

    void ajuster() {
        Dimension voulue = taille.get();
        if (adopte != null && (voulue.width != courant.dessin.largeur || voulue.height != courant.dessin.hauteur)) {
            redessiner(false);
        }
    }

    void arreter() {
        if (enCours) {
            courant.arreter();
            observer();
        }
    }

    void terminer() {
        if (courant != null) {
            courant.arreter();
        }
        surveillance.terminer();
        dessins.shutdown();
    }

    private void redessiner(boolean geste) {
        // une scène en cours de lecture passe avant la scène montrée
        boolean autre = enCours && courant.aLire && courant != adopte;
        lancer((autre ? courant.dessin : source).avec(taille.get().width, taille.get().height), geste);
    }

    /** L'image achevée devient l'image « avant », sauf si elle est trop grande ou si c'est une vue. */
    private void retenir() {
        if (complete == null || complete.sens.equals(ImageMemoire.COULEUR)) {
            avant = complete != null && complete.codes.length <= PIXELS_GARDES ? complete : null;
        }
    }

    private boolean estDeLaTaille(ImageMemoire image, Dessin dessin) {
        return image != null && image.largeur == dessin.largeur && image.hauteur == dessin.hauteur;
    }

    /** @param geste vrai si le geste peut continuer : l'image attend alors un peu après le brouillon */
    private void lancer(Dessin dessin, boolean geste) {
        enAttente = false;
        if (dessins.isShutdown()) {
            return;
        }
        if (courant != null) {
            courant.arreter();
        }
        dessin.setVue(vue, estDeLaTaille(avant, dessin) ? avant : null);
        Tracage tracage = new Tracage(programme, dessin, reglages,
                panneau.getTailleMax(dessin.largeur, dessin.hauteur), fils);
        if (geste) {
            dessin.setEntracte(() -> {
                EventQueue.invokeLater(this::observer);
                tracage.attendreLaSuite();
            });
        }
        dessins.execute(tracage);
        suivre(tracage);
    }

    private void suivre(Tracage tracage) {
        courant = tracage;
        enCours = true;
        panneau.dire("");
        avertir();
        observer();
    }

    /** Lit l'état du dessin en cours et le montre ; à appeler souvent. */
    void observer() {
        boolean fini = courant.isDone();
        if (panneau.peinte) {
            courant.vue.countDown();
        }
        Dessin dessin = courant.dessin;
        if (courant.aLire && dessin.getLue() != null && !courant.lueDite) {
            courant.lueDite = true;
            // la scène n'a plus de faute, même si son image n'est pas encore montrée
            panneau.bandeau.dire(Sujet.SCENE, "");
        }
        ImageMemoire image = dessin.getImage();
        if (image != null && (image == panneau.montree || dessin.isBrouillonFait()
                // sans image, une partie du brouillon est montrée
                || panneau.montree == null && (fini || courant.getDureeNs() > PATIENCE_NS))) {
            panneau.montree = image;
            panneau.repaint();
            if (montre != dessin) {
                montre = dessin;
                adopter();
            }
        }
        if (panneau.apercu != dessin.getApercu()) {
            panneau.apercu = dessin.getApercu();
            panneau.repaint();
        }
        if (dessin.getLenteur() != null && !courant.lenteurDite) {
            courant.lenteurDite = true;
            panneau.bandeau.dire(Sujet.DESSIN, dessin.getLenteur());
        }
        if (fini && enCours) {
            finir();
        }
        if (enAttente && (fini || dessin.isBrouillonFait())) {
            redessiner(true);
        }
    }

    /** Si ce dessin a lu une scène, elle devient la scène montrée. */
    private void adopter() {
        if (courant.aLire && courant != adopte) {
            adopte = courant;
            reglages = adopte.dessin.getReglages();
            fichier = adopte.dessin.fichier;
            surveillance.suivre(fichier, courant.version);
            panneau.bandeau.dire(Sujet.DESSIN, "");
            List<String> avis = new ArrayList<>(adopte.dessin.getLue().avertissements);
            if (estDeplacee()) {
                avis.add("scène relue : ce qui avait été déplacé a repris la place que dit son fichier");
                avantDeplacements.clear();
            }
            source = adopte.dessin;
            panneau.bandeau.dire(Sujet.AVIS, String.join("\n", avis));
        }
        avertir();
    }

    private void finir() {
        enCours = false;
        courant.vue.countDown();
        Throwable panne = courant.getPanne();
        Fautes fautes = courant.dessin.getLancer() == null ? null : courant.dessin.getLancer().getFautes();
        if (courant.isAcheve()) {
            complete = montre.getImage();
            // les sections ignorées, sans le reste de leur avertissement
            String ignorees = String.join("\n", montre.getLue().avertissements)
                    .replaceAll(".*, ligne \\d+, (\\[[^]]*]).*\n?", ", $1 ignorée");
            complete.legende = montre.getCout() + ", " + montre.getReglages() + ignorees
                    + (fautes.enMots() == null ? "" : ", " + fautes.enMots());
            if (montre.getEcart() != null) {
                panneau.bandeau.dire(Sujet.AVIS, montre.getEcart());
            }
        }
        if (panne instanceof SceneFautive && courant.aLire) {
            refuser(Pannes.message(panne));
        } else if (fautes != null && fautes.enMots() != null && !(panne instanceof Error)) {
            panneau.bandeau.dire(Sujet.DESSIN, fautes.enMots() + (panne == null ? "" : ", et aucun n'a pu l'être")
                    + " ; le premier : " + courant.dessin.nommer(fautes.getPremiere()).getMessage());
        } else if (panne != null || courant.isAcheve()) {
            panneau.bandeau.dire(Sujet.DESSIN, panne == null ? "" : Pannes.message(panne));
        }
        if (fichier == null) {
            fichier = courant.dessin.fichier;
            panneau.dire("F5 pour lire la scène et la dessiner");
        }
        avertir();
    }

    /** Phrase qui donne le nombre de pixels fautifs de l'image montrée ; {@code null} s'il n'y en a pas. */
    String direFautes() {
        return montre == null ? null : montre.getLancer().getFautes().enMots();
    }

    /** Refuse la scène lue. La scène montrée reste ; si c'est son fichier qui est fautif, il reste surveillé. */
    private void refuser(String message) {
        panneau.bandeau.dire(Sujet.SCENE, message);
        if (fichier == null || courant.dessin.fichier.equals(fichier)) {
            fichier = courant.dessin.fichier;
            surveillance.suivre(fichier, courant.version);
        }
        if (adopte != null && getImageComplete() == null) {
            // la faute a interrompu le dessin de la scène d'avant : il est repris
            retenir();
            redessiner(false);
        }
    }
}
