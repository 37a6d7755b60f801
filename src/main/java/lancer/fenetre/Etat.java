package lancer.fenetre;

import java.io.File;
import java.util.ArrayList;
import java.util.List;
import lancer.commande.Messages;
import lancer.contrat.PixelFautif;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;
import lancer.scene.SceneLue;
import lancer.texte.Texte;

/**
 * L'état de la fenêtre, que {@link Controleur} publie à chaque changement. Immuable : une méthode dont le nom commence
 * par {@code avec} rend le même état, à son argument près.
 */
final class Etat {

    /** Le plus grand nombre de pixels d'une image « avant » gardée. */
    private static final int PIXELS_GARDES = 16_000_000;

    final Source source;
    /** Ce qui est demandé de la scène montrée, déplacements compris ; {@code null} avant la première. */
    final Demande demande;
    /** La scène que contient le fichier de la scène montrée ; {@code null} avant la première. */
    final SceneLue ecrite;
    /** Le dernier travail commencé, ou {@code null}, et vrai tant qu'il n'est pas fini. */
    final Travail travail;
    final boolean enCours;
    final Montre montre;

    private Etat(Source source, Demande demande, SceneLue ecrite, Travail travail, boolean enCours, Montre montre) {
        this.source = source;
        this.demande = demande;
        this.ecrite = ecrite;
        this.travail = travail;
        this.enCours = enCours;
        this.montre = montre;
    }

    /** Celui d'une fenêtre sans scène. */
    Etat() {
        this(new Source(null, null, null), null, null, null, false, new Montre(null, false, null));
    }

    /** Le fichier de la scène demandée en dernier, même fautif : celui du titre, de F5 et de la surveillance. */
    static final class Source {

        final String fichier;
        /** La version qui a été lue, ou écrite par cette fenêtre ; {@code null} pendant une lecture. */
        final String version;
        /** Ce qui a échoué avec cette version ; {@code null} si rien. */
        final String faute;

        Source(String fichier, String version, String faute) {
            this.fichier = fichier;
            this.version = version;
            this.faute = faute;
        }
    }

    /** L'image montrée. */
    static final class Montre {

        /** Le dessin de l'image ou du brouillon, ou {@code null}, et vrai si cette image est achevée. */
        final Dessin dessin;
        final boolean entier;
        /** Le dessin achevé avant le dernier changement ; {@code null} s'il n'y en a pas, ou s'il est trop grand. */
        final Dessin avant;

        Montre(Dessin dessin, boolean entier, Dessin avant) {
            this.dessin = dessin;
            this.entier = entier;
            this.avant = avant;
        }

        /** L'image achevée devient celle d'avant, sauf si elle est trop grande ou si c'est une vue. */
        Montre retenu() {
            if (!entier || dessin.demande.vue != null) {
                return this;
            }
            return new Montre(dessin, true, dessin.image.codes.length <= PIXELS_GARDES ? dessin : null);
        }

        /** Phrase qui donne le nombre de pixels fautifs ; {@code null} s'il n'y en a pas. */
        String direFautes() {
            return dessin == null ? null : dessin.lancer.getAtelier().getFautes().enMots();
        }
    }

    Etat avec(Source autre) {
        return new Etat(autre, demande, ecrite, travail, enCours, montre);
    }

    Etat avec(Demande autre) {
        return new Etat(source, autre, ecrite, travail, enCours, montre);
    }

    Etat avec(SceneLue autre) {
        return new Etat(source, demande, autre, travail, enCours, montre);
    }

    Etat avec(Travail autre, boolean commence) {
        return new Etat(source, demande, ecrite, autre, commence, montre);
    }

    Etat avec(Montre autre) {
        return new Etat(source, demande, ecrite, travail, enCours, autre);
    }

    /** Le nom, sans dossier, du fichier de la scène montrée. */
    String getNom() {
        return Texte.echappe(new File(demande.lue.nom).getName());
    }

    /** Dit si l'image montrée est d'une autre scène que celle qui est demandée. */
    boolean montreUneAutre() {
        return demande != null && !demande.lue.nom.equals(source.fichier);
    }

    /** Dit si la scène montrée est celle que contient cette version du fichier demandé. */
    boolean connait(String version) {
        return demande != null && !montreUneAutre() && version.equals(ecrite.getVersion());
    }

    /** Dit si un déplacement n'est pas dans le fichier de la scène montrée. */
    boolean estDeplace() {
        return demande != null && demande.lue != ecrite;
    }

    /** L'image montrée si elle est achevée, même si un autre dessin est commencé ; {@code null} sinon. */
    ImageMemoire getImageEntiere() {
        return montre.entier ? montre.dessin.image : null;
    }

    /** La version connue du fichier demandé, ou celle qui se lit ; {@code null} si elle n'est pas encore connue. */
    String getVersion() {
        return source.version != null || travail == null ? source.version : travail.version;
    }

    /** Ce qui a échoué, une ligne chacun : du fichier demandé, puis du dessin. */
    List<String> getFautes() {
        List<String> fautes = new ArrayList<>();
        if (source.faute != null) {
            fautes.add(source.faute);
            if (montreUneAutre()) {
                fautes.add("l'image qui reste est celle de " + getNom());
            }
        }
        Throwable echec = enCours || travail == null ? null : travail.getEchec();
        if (montre.direFautes() != null && (montre.entier || !enCours) && !(echec instanceof Error)) {
            PixelFautif premier = montre.dessin.lancer.getAtelier().getFautes().getPremiere();
            fautes.add(montre.direFautes() + " ; le premier : " + montre.dessin.demande.nommer(premier).getMessage());
        } else if (echec != null && travail.lue) {
            fautes.add(Messages.message(echec));
        }
        return fautes;
    }
}
