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
 * La vie d'un dessin dans la fenêtre, jusqu'à sa fin, son arrêt ou sa panne. La scène montrée le reste tant que rien ne
 * se voit d'une autre. {@link Tracage} travaille ailleurs ; ici, tout s'appelle dans le fil des événements.
 */
final class Controleur {

    /** Temps laissé au premier brouillon avant d'en montrer un morceau ; plus grande image d'avant qui se garde. */
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

    // ce qui suit se lit de toute la fenêtre, et ne s'écrit qu'ici
    /** Le fichier du titre, de F5 et de la surveillance : la scène montrée, ou la première si elle est fautive. */
    String fichier;
    /** Le dernier dessin commencé, et le premier de la scène montrée ; {@code null} s'il n'y en a pas. */
    Tracage courant;
    Tracage adopte;
    /** Les réglages de la scène montrée, que son dessin soit achevé ou non ; {@code null} avant la première. */
    ReglagesDessin reglages;
    /** Vrai tant qu'un dessin est en cours, lecture et préparation comprises, et que {@link #finir} n'est pas passé. */
    boolean enCours;
    /** Le dessin dont l'image se voit, brouillon au moins : ce qui s'inspecte, s'agrandit, s'enregistre, se compare. */
    Dessin montre;
    /** La scène montrée, telle qu'elle est lue ou qu'on l'a déplacée ; {@code null} avant la première. */
    Dessin source;
    /** La vue en fausses couleurs qui remplace l'image ; {@code null} : aucune. */
    String vue;
    /** L'image qui était achevée avant le dernier geste ; {@code null} s'il n'y en a pas, ou trop grande. */
    ImageMemoire avant;

    private final Deque<Dessin> avantDeplacements = new ArrayDeque<>();
    private ImageMemoire complete;
    /** Vrai si d'autres réglages attendent que le brouillon en cours se soit vu. */
    private boolean enAttente;

    /** @param premier dessin, dont sont faits ceux d'autres scènes @param programme qui dessine, dans ce fil-là */
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

    /** Un fil à part, où les tâches attendent leur tour ; oisif il s'en va, et ne retient jamais le programme. */
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

    /** Donne une tâche à ce fil ; si elle échoue sans qu'on l'ait arrêtée, {@code siPanne} l'apprend, sur le sien. */
    static Future<?> confier(ExecutorService fil, Runnable tache, Consumer<String> siPanne) {
        return fil.submit(() -> {
            try {
                tache.run();
            } catch (CancellationException e) {
                // ce qu'elle calculait n'est plus demandé
            } catch (RuntimeException | Error e) {
                EventQueue.invokeLater(() -> siPanne.accept(Pannes.message(e)));
            }
        });
    }

    /** Appelle {@code siChange} chaque fois qu'un dessin commence, s'achève ou s'arrête, et qu'une scène est lue. */
    void prevenir(Runnable siChange) {
        prevenus.add(siChange);
    }

    /** La commande qui dessine la scène montrée avec ces réglages, sections changées mises dans son fichier. */
    String getCommande() {
        return Pannes.commande("", reglages.getOptions(), fichier, taille.get().width, taille.get().height);
    }

    /** L'image montrée si elle est achevée, qu'une autre se prépare ou non ; {@code null} sinon. */
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

    /** Lit cette scène et la dessine ; ce qui se dessinait est abandonné. */
    void ouvrir(String scene) {
        retenir();
        lancer(premier.pour(scene, taille.get().width, taille.get().height), false);
    }

    void relire() {
        ouvrir(fichier);
    }

    /** Le fichier de la scène montrée a changé ; une autre scène qui se lit passe avant. */
    private void suivreFichier() {
        if (!enCours || !courant.aLire || courant.dessin.fichier.equals(fichier)) {
            relire();
        }
    }

    /** Dessine la scène montrée avec ces réglages. @param suite si ce geste continue : « avant » reste avant lui */
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

    /** Remplace l'image par cette vue en fausses couleurs. @param voulue {@code null} pour l'image */
    void voir(String voulue) {
        vue = voulue;
        redessiner(false);
    }

    /** Remplace un objet ou une lampe de la scène montrée, en mémoire seulement. @param suite si ce geste continue */
    void deplacer(Object ancien, Object nouveau, boolean suite) {
        if (!suite) {
            avantDeplacements.push(source);
        }
        source = source.avec(new SceneLue(source.getLue(), ancien, nouveau));
        dessiner(reglages, suite);
    }

    /** Défait le dernier déplacement. */
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
        // une scène qui se lit, et ne se voit pas encore, passe avant
        boolean autre = enCours && courant.aLire && courant != adopte;
        lancer((autre ? courant.dessin : source).avec(taille.get().width, taille.get().height), geste);
    }

    /** L'image achevée devient celle d'avant ; une trop grande ne se garde pas, et une vue n'en est pas une. */
    private void retenir() {
        if (complete == null || complete.sens.equals(ImageMemoire.COULEUR)) {
            avant = complete != null && complete.codes.length <= PIXELS_GARDES ? complete : null;
        }
    }

    private boolean estDeLaTaille(ImageMemoire image, Dessin dessin) {
        return image != null && image.largeur == dessin.largeur && image.hauteur == dessin.hauteur;
    }

    /** @param geste vrai s'il peut continuer : l'image ne vient qu'un moment après le brouillon */
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
        prevenus.forEach(Runnable::run);
        observer();
    }

    /** Regarde où en est le dessin en cours, et le montre ; à appeler souvent. */
    void observer() {
        boolean fini = courant.isDone();
        if (panneau.peinte) {
            courant.vue.countDown();
        }
        Dessin dessin = courant.dessin;
        if (courant.aLire && dessin.getLue() != null && !courant.lueDite) {
            courant.lueDite = true;
            // il n'y a plus de faute, même si l'image se fait attendre
            panneau.bandeau.dire(Sujet.SCENE, "");
        }
        ImageMemoire image = dessin.getImage();
        if (image != null && (image == panneau.montree || dessin.isBrouillonFait()
                // à défaut d'image, un morceau de brouillon vaut mieux que du gris
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

    /** La scène que ce dessin a lue, s'il en a lu une, devient celle qui est montrée. */
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
        prevenus.forEach(Runnable::run);
    }

    private void finir() {
        enCours = false;
        courant.vue.countDown();
        Throwable panne = courant.getPanne();
        Fautes fautes = courant.dessin.getLancer() == null ? null : courant.dessin.getLancer().getFautes();
        if (courant.isAcheve()) {
            complete = montre.getImage();
            // les sections laissées de côté, sans le reste de leur avertissement
            String ignorees = String.join("\n", montre.getLue().avertissements)
                    .replaceAll(".*, ligne \\d+, (\\[[^]]*]).*\n?", ", $1 ignorée");
            complete.legende = montre.getCout() + ", " + (vue == null ? "" : "vue " + vue + ", ")
                    + montre.getReglages() + ignorees
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
        prevenus.forEach(Runnable::run);
    }

    /** Phrase qui dit combien de pixels de l'image montrée n'ont pu être calculés ; {@code null} si aucun. */
    String direFautes() {
        return montre == null ? null : montre.getLancer().getFautes().enMots();
    }

    /** La scène montrée reste ; si c'est elle qui est devenue fautive, elle reste aussi surveillée. */
    private void refuser(String message) {
        panneau.bandeau.dire(Sujet.SCENE, message);
        if (fichier == null || courant.dessin.fichier.equals(fichier)) {
            fichier = courant.dessin.fichier;
            surveillance.suivre(fichier, courant.version);
        }
        if (adopte != null && getImageComplete() == null) {
            // la faute a interrompu un dessin de la scène d'avant : c'est lui, la dernière bonne image
            retenir();
            redessiner(false);
        }
    }
}
