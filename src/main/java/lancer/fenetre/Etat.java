package lancer.fenetre;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import lancer.dessin.Dessin;
import lancer.dessin.ReglagesDessin;
import lancer.image.ImageMemoire;

/** L'état de la fenêtre, que tous ses panneaux montrent. Immuable : {@link Controleur} le remplace par le suivant. */
final class Etat {

    /** La plus grande image « avant » gardée, en pixels. */
    private static final int PIXELS_GARDES = 16_000_000;

    /** L'état au départ : aucune scène n'est demandée. */
    static final Etat VIDE = new Etat(null, null, null, Collections.emptyList(), Collections.emptyList(), null, false,
            null, false, null);

    /** Le fichier de la scène demandée en dernier, même fautive : celui du titre, de F5 et de la surveillance. */
    final String demande;
    /** Le dessin qui a lu la scène montrée, et ce qui est choisi pour elle ; {@code null} avant la première. */
    final Tracage lecture;
    final Choix choix;
    private final List<Choix> passes;
    private final List<Choix> futurs;
    /** Le dernier dessin commencé, et vrai tant qu'il n'est pas fini, lecture et préparation comprises. */
    final Tracage courant;
    final boolean enCours;
    /** Le dessin dont l'image ou le brouillon est montré, ou {@code null}, et vrai si cette image est achevée. */
    final Dessin montre;
    final boolean entiere;
    /** L'image achevée avant le dernier geste ; {@code null} s'il n'y en a pas, ou si elle est trop grande. */
    final ImageMemoire avant;

    private Etat(String demande, Tracage lecture, Choix choix, List<Choix> passes, List<Choix> futurs, Tracage courant,
            boolean enCours, Dessin montre, boolean entiere, ImageMemoire avant) {
        this.demande = demande;
        this.lecture = lecture;
        this.choix = choix;
        this.passes = passes;
        this.futurs = futurs;
        this.courant = courant;
        this.enCours = enCours;
        this.montre = montre;
        this.entiere = entiere;
        this.avant = avant;
    }

    ReglagesDessin getReglages() {
        return choix == null ? null : choix.reglages;
    }

    /** L'image montrée si elle est achevée, même si un autre dessin est commencé ; {@code null} sinon. */
    ImageMemoire getImageEntiere() {
        return entiere ? montre.getImage() : null;
    }

    boolean estDeplace() {
        return choix != null && choix.estDeplace();
    }

    boolean peutRevenir(boolean refaire) {
        return !(refaire ? futurs : passes).isEmpty();
    }

    /** Vrai tant que la scène demandée se lit ou se prépare : celle qui est montrée en est une autre. */
    boolean lit() {
        return enCours && courant.aLire && courant != lecture;
    }

    Etat demander(String fichier) {
        return new Etat(fichier, lecture, choix, passes, futurs, courant, enCours, montre, entiere, retenue());
    }

    Etat commencer(Tracage tracage) {
        return new Etat(demande, lecture, choix, passes, futurs, tracage, true, montre, entiere, avant);
    }

    /** La scène lue par le dessin en cours est montrée. @param defait vrai si son fichier défait un déplacement */
    Etat adopter(boolean defait) {
        boolean relue = courant.litLaSceneDe(lecture);
        List<Choix> nouveaux = relue ? defait ? plus(passes, choix) : passes : Collections.emptyList();
        return new Etat(demande, courant, courant.choix, nouveaux, relue ? futurs : Collections.emptyList(), courant,
                enCours, montre, entiere, avant);
    }

    /** @param suite vrai si le geste continue : ni l'image d'avant ni ce que Ctrl+Z retrouve ne changent */
    Etat choisir(Choix voulu, boolean suite) {
        return new Etat(demande, lecture, voulu, suite ? passes : plus(passes, choix), Collections.emptyList(), courant,
                enCours, montre, entiere, suite ? avant : avant(voulu));
    }

    /** Défait le dernier choix, ou le refait. */
    Etat revenir(boolean refaire) {
        List<Choix> de = refaire ? futurs : passes;
        Choix voulu = de.get(de.size() - 1).pour(lecture.getLu(), true);
        List<Choix> reste = de.subList(0, de.size() - 1);
        List<Choix> vers = plus(refaire ? passes : futurs, choix);
        return new Etat(demande, lecture, voulu, refaire ? vers : reste, refaire ? reste : vers, courant, enCours,
                montre, entiere, avant(voulu));
    }

    /** L'image du dessin en cours est montrée. */
    Etat montrer() {
        return new Etat(demande, lecture, choix, passes, futurs, courant, enCours, courant.dessin, false, avant);
    }

    Etat finir() {
        return new Etat(demande, lecture, choix, passes, futurs, courant, false, montre,
                courant.isAcheve() || entiere, avant);
    }

    /** L'image achevée, qui devient celle d'avant, sauf si elle est trop grande ou si c'est une vue. */
    private ImageMemoire retenue() {
        ImageMemoire image = getImageEntiere();
        return image == null || !image.sens.equals(ImageMemoire.COULEUR) ? avant
                : image.codes.length <= PIXELS_GARDES ? image : null;
    }

    /** Une vue se compare à la même image que la précédente : elle ne change pas celle d'avant. */
    private ImageMemoire avant(Choix voulu) {
        return Objects.equals(voulu.vue, choix.vue) ? retenue() : avant;
    }

    private static List<Choix> plus(List<Choix> liste, Choix dernier) {
        List<Choix> autre = new ArrayList<>(liste);
        autre.add(dernier);
        return Collections.unmodifiableList(autre);
    }
}
