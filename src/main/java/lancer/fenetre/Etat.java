package lancer.fenetre;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import lancer.commande.Reglages;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;

/** L'état de la fenêtre, que tous ses panneaux montrent. Immuable : {@link Controleur} le remplace par le suivant. */
final class Etat {

    /** La plus grande image « avant » gardée, en pixels. */
    private static final int PIXELS_GARDES = 16_000_000;

    /** L'état au départ : aucune scène n'est demandée. */
    static final Etat VIDE = new Etat(null, null, Collections.emptyList(), -1, null, false, null, false, null);

    /** Le fichier de la scène demandée en dernier, même fautive : celui du titre, de F5 et de la surveillance. */
    final String demande;
    /** Le dessin qui a lu la scène montrée, et ce qui est choisi pour elle ; {@code null} avant la première. */
    final Tracage lecture;
    final Choix choix;
    /** Les choix que Ctrl+Z retrouve, celui-ci, dont le rang est donné, et ceux qui sont défaits. */
    private final List<Choix> histoire;
    private final int rang;
    /** Le dernier dessin commencé, et vrai tant qu'il n'est pas fini, lecture et préparation comprises. */
    final Tracage courant;
    final boolean enCours;
    /** Le dessin dont l'image ou le brouillon est montré, ou {@code null}, et vrai si cette image est achevée. */
    final Dessin montre;
    final boolean entiere;
    /** L'image achevée avant le dernier geste ; {@code null} s'il n'y en a pas, ou si elle est trop grande. */
    final ImageMemoire avant;

    private Etat(String demande, Tracage lecture, List<Choix> histoire, int rang, Tracage courant, boolean enCours,
            Dessin montre, boolean entiere, ImageMemoire avant) {
        this.demande = demande;
        this.lecture = lecture;
        this.histoire = histoire;
        this.rang = rang;
        this.choix = rang < 0 ? null : histoire.get(rang);
        this.courant = courant;
        this.enCours = enCours;
        this.montre = montre;
        this.entiere = entiere;
        this.avant = avant;
    }

    Reglages getReglages() {
        return choix == null ? null : choix.reglages;
    }

    /** L'image montrée si elle est achevée, même si un autre dessin est commencé ; {@code null} sinon. */
    ImageMemoire getImageEntiere() {
        return entiere ? montre.image : null;
    }

    /** Vrai si quelque chose de déplacé n'est pas dans le fichier. */
    boolean estDeplace() {
        return choix != null && choix.scene != choix.lue;
    }

    /** Dit si un choix peut être défait ({@code sens} −1) ou refait (1). */
    boolean peutRevenir(int sens) {
        return rang + sens >= 0 && rang + sens < histoire.size();
    }

    /** Vrai tant que la scène demandée se lit ou se prépare : celle qui est montrée en est une autre. */
    boolean lit() {
        return enCours && courant.aLire && courant != lecture;
    }

    Etat demander(String fichier) {
        return new Etat(fichier, lecture, histoire, rang, courant, enCours, montre, entiere, retenue());
    }

    Etat commencer(Tracage tracage) {
        return new Etat(demande, lecture, histoire, rang, tracage, true, montre, entiere, avant);
    }

    /** La scène lue par le dessin en cours est montrée. @param defait vrai si son fichier défait un déplacement */
    Etat adopter(boolean defait) {
        boolean relue = courant.litLaSceneDe(lecture);
        return choisir(courant, courant.choix, !relue ? 0 : defait ? rang + 1 : rang,
                relue ? rang + 1 : histoire.size(), avant);
    }

    /** @param suite vrai si le geste continue : ni l'image d'avant ni ce que Ctrl+Z retrouve ne changent */
    Etat choisir(Choix voulu, boolean suite) {
        return choisir(lecture, voulu, suite ? rang : rang + 1, histoire.size(), suite ? avant : avant(voulu));
    }

    /** Défait le dernier choix ({@code sens} −1), ou le refait (1). */
    Etat revenir(int sens) {
        Choix voulu = histoire.get(rang + sens).pour(lecture.getLu(), true);
        return choisir(lecture, voulu, rang + sens, rang + sens + 1, avant(voulu));
    }

    /** @param ici le rang de {@code voulu} @param reste celui du premier des choix défaits qui restent à refaire */
    private Etat choisir(Tracage autre, Choix voulu, int ici, int reste, ImageMemoire image) {
        List<Choix> suivie = new ArrayList<>(histoire.subList(0, ici));
        suivie.add(voulu);
        suivie.addAll(histoire.subList(reste, histoire.size()));
        return new Etat(demande, autre, suivie, ici, courant, enCours, montre, entiere, image);
    }

    /** L'image du dessin en cours est montrée. */
    Etat montrer() {
        return new Etat(demande, lecture, histoire, rang, courant, enCours, courant.dessin, false, avant);
    }

    Etat finir() {
        return new Etat(demande, lecture, histoire, rang, courant, false, montre, courant.isAcheve() || entiere, avant);
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
}
