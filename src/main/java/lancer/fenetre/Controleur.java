package lancer.fenetre;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.io.File;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.Supplier;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Programme;
import lancer.fenetre.Bandeau.Sujet;
import lancer.image.ImageMemoire;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;

/**
 * L'état de la fenêtre, et la suite de ses dessins. Tout y est appelé dans le fil des événements ; {@link Travail}
 * calcule dans un autre. La scène montrée reste la même jusqu'au premier brouillon d'une autre.
 */
final class Controleur implements Travail.Suite {

    /** La plus grande image « avant » gardée, en pixels. */
    private static final int PIXELS_GARDES = 16_000_000;

    private final Programme programme;
    private final Options options;
    final PanneauImage panneau;
    private final Supplier<Dimension> taille;
    private final Surveillance surveillance;
    private final List<Runnable> prevenus = new ArrayList<>();

    /** Le fichier de la scène demandée en dernier, même fautive : celui du titre, de F5 et de la surveillance. */
    String fichier;
    /** Ce qui est demandé de la scène montrée ; {@code null} avant la première. */
    Demande demande;
    /** Le dernier travail commencé, et vrai tant qu'il n'est pas fini. */
    Travail travail;
    boolean enCours;
    /** Le dessin dont l'image ou le brouillon est montré, ou {@code null}, et vrai si cette image est achevée. */
    Dessin montre;
    boolean entiere;
    /** Le dessin achevé avant le dernier changement ; {@code null} s'il n'y en a pas, ou s'il est trop grand. */
    Dessin avant;
    /** Reçoit chaque scène lue, et dit si ce qui était déplacé sans être écrit est perdu. */
    Predicate<SceneLue> oubli = lue -> false;

    /** @param taille donne la taille de l'image à dessiner */
    Controleur(Programme programme, Options options, PanneauImage panneau, Supplier<Dimension> taille) {
        this.programme = programme;
        this.options = options;
        this.panneau = panneau;
        this.taille = taille;
        surveillance = new Surveillance(() -> EventQueue.invokeLater(this::relire));
    }

    /** Appelle {@code siChange} quand l'état de la fenêtre change. */
    void prevenir(Runnable siChange) {
        prevenus.add(siChange);
    }

    void avertir() {
        prevenus.forEach(Runnable::run);
    }

    /** L'image montrée si elle est achevée, même si un autre dessin est commencé ; {@code null} sinon. */
    ImageMemoire getImageEntiere() {
        return entiere ? montre.image : null;
    }

    /** Nombre de fils d'un dessin. */
    int getFils() {
        return options.get(Option.FILS);
    }

    /** Montre le premier dessin de la fenêtre, déjà demandé ; sa scène est lue. */
    void ouvrir(Travail premier) {
        fichier = premier.demande.lue.nom;
        surveillance.suivre(fichier, premier.version);
        adopter(premier.demande);
        commencer(premier);
    }

    /** Lit cette scène et la dessine ; le dessin en cours est abandonné. */
    void ouvrir(String scene) {
        retenir();
        fichier = scene;
        commencer(new Travail(programme, options, scene, demande));
    }

    void relire() {
        ouvrir(fichier);
    }

    /** Dessine la scène avec ces réglages ; s'ils sont impossibles, un avis le dit. */
    void regler(Reglages voulus) {
        if (voulus.equals(demande.reglages)) {
            return;
        }
        try {
            Demande reglee = demande.avecReglages(voulus);
            retenir();
            demander(reglee);
        } catch (SceneFautive e) {
            panneau.bandeau.dire(Sujet.AVIS, e.getMessage());
            avertir();
        }
    }

    /** Revient aux réglages de la ligne de commande et du fichier. */
    void revenir() {
        regler(new Demande(demande.lue, options).reglages);
    }

    /** Montre cette vue. @param vue {@code null} pour l'image */
    void voir(String vue) {
        demander(demande.avecVue(vue));
    }

    /** Dessine la scène lue, avec ces déplacements. */
    void deplacer(SceneLue deplacee) {
        retenir();
        demander(demande.avecLecture(deplacee));
    }

    /** Suit la taille que la fenêtre donne à l'image. */
    void ajuster() {
        if (demande != null && !taille.get().equals(new Dimension(demande.largeur, demande.hauteur))) {
            demander(demande);
        }
    }

    void arreter() {
        if (enCours) {
            travail.cancel(true);
        }
    }

    void terminer() {
        arreter();
        // ce que ce travail a publié n'est plus attendu
        travail = null;
        enCours = false;
        surveillance.terminer();
    }

    /** L'image achevée devient celle d'avant, sauf si elle est trop grande ou si c'est une vue. */
    private void retenir() {
        ImageMemoire image = getImageEntiere();
        if (image != null && image.sens.equals(ImageMemoire.COULEUR)) {
            avant = image.codes.length <= PIXELS_GARDES ? montre : null;
        }
    }

    /** Demande ce dessin. Si un brouillon se prépare, il est d'abord montré. */
    private void demander(Demande voulue) {
        demande = voulue.avecTaille(taille.get().width, taille.get().height);
        if (!enCours) {
            dessiner();
        } else if (travail.aSonBrouillon()) {
            montrer(travail);
        }
        avertir();
    }

    /** Commence le dessin de ce qui est demandé, s'il ne l'est pas déjà. */
    private void dessiner() {
        if (enCours ? !demande.equals(travail.demande) : !entiere || !demande.equals(montre.demande)) {
            commencer(new Travail(programme, demande));
        }
    }

    private void commencer(Travail nouveau) {
        arreter();
        travail = nouveau;
        enCours = true;
        nouveau.suite = this;
        nouveau.execute();
        avertir();
    }

    @Override
    public void lue(Travail celui) {
        if (celui == travail) {
            surveillance.suivre(fichier, celui.version);
            panneau.bandeau.dire(Sujet.SCENE, "");
        }
    }

    @Override
    public void montrer(Travail celui) {
        if (celui != travail || celui.isCancelled() && montre != null) {
            return;
        }
        // sans image, un brouillon se montre dès son début
        if (montre != celui.dessin && (montre == null || celui.aSonBrouillon())) {
            if (celui.aLire != null) {
                adopter(celui.demande);
            }
            montre = celui.dessin;
            entiere = false;
            panneau.montree = montre.image;
            avertir();
        }
        if (celui.aSonBrouillon() && !celui.isCancelled()) {
            dessiner();
        }
    }

    /** La scène montrée est désormais celle qui vient d'être lue. */
    private void adopter(Demande lue) {
        demande = demande == null ? lue : demande.avecLecture(lue.lue);
        List<String> avis = new ArrayList<>(lue.lue.avertissements);
        if (oubli.test(lue.lue)) {
            avis.add("scène relue : ce qui était déplacé sans être écrit est revenu à sa place");
        }
        panneau.bandeau.dire(Sujet.DESSIN, "");
        if (!avis.isEmpty()) {
            panneau.bandeau.dire(Sujet.AVIS, String.join("\n", avis));
        }
    }

    @Override
    public void finir(Travail celui) {
        if (celui != travail) {
            return;
        }
        enCours = false;
        if (!celui.lue) {
            surveillance.suivre(fichier, celui.version);
        }
        Dessin dessin = celui.dessin;
        Throwable echec = celui.getEchec();
        String fautes = dessin == null ? null : dessin.lancer.getAtelier().getFautes().enMots();
        if (celui.estAcheve()) {
            entiere = true;
            if (dessin.getEcart() != null) {
                panneau.bandeau.dire(Sujet.AVIS, dessin.getEcart());
            }
        }
        if (echec instanceof SceneFautive && !celui.lue) {
            boolean autre = demande != null && !demande.lue.nom.equals(fichier);
            panneau.bandeau.dire(Sujet.SCENE, Messages.message(echec) + (autre ? "\nl'image qui reste est celle de "
                    + new File(demande.lue.nom).getName() : ""));
        } else if (fautes != null && !(echec instanceof Error)) {
            panneau.bandeau.dire(Sujet.DESSIN, fautes + " ; le premier : "
                    + dessin.demande.nommer(dessin.lancer.getAtelier().getFautes().getPremiere()).getMessage());
        } else if (echec != null || celui.estAcheve()) {
            panneau.bandeau.dire(Sujet.DESSIN, echec == null ? "" : Messages.message(echec));
        }
        if (echec != null && demande != null && (!celui.lue || !demande.equals(celui.demande))) {
            // la lecture a interrompu le dessin d'avant, ou autre chose a été demandé avant cet échec
            dessiner();
        }
        avertir();
    }

    /** Le coût d'un dessin achevé, ses réglages, ses fautes. */
    static String decrire(Dessin dessin) {
        String fautes = dessin.lancer.getAtelier().getFautes().enMots();
        return dessin.getCout() + ", " + dessin.demande.reglages + (fautes == null ? "" : ", " + fautes);
    }

    /** Phrase qui donne le nombre de pixels fautifs de l'image montrée ; {@code null} s'il n'y en a pas. */
    String direFautes() {
        return montre == null ? null : montre.lancer.getAtelier().getFautes().enMots();
    }
}
