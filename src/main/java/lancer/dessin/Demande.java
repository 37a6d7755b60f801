package lancer.dessin;

import java.util.Objects;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.Couple;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.Cause;
import lancer.contrat.PixelFautif;
import lancer.scene.LecteurSections;
import lancer.scene.SceneLue;
import lancer.systeme.Console;
import lancer.systeme.Echec;
import lancer.texte.Texte;

/**
 * Ce qui est demandé : une scène lue, et ses réglages, dont une taille, et une vue en fausses couleurs ou l'image.
 * Immuable. Une méthode dont le nom commence par {@code avec} rend la même demande, à son argument près.
 */
public final class Demande {

    public final SceneLue lue;
    public final Reglages reglages;
    public final int largeur;
    public final int hauteur;
    /** Le nom de la vue ; {@code null} pour l'image. */
    public final String vue;
    /** Les objets, les lampes et la caméra, ainsi réglés. */
    private final Scene scene;

    private Demande(SceneLue lue, Reglages reglages, Scene scene) {
        this.lue = lue;
        this.reglages = reglages;
        this.scene = scene;
        largeur = reglages.get(Option.TAILLE).x;
        hauteur = reglages.get(Option.TAILLE).y;
        vue = reglages.get(Option.VUE);
    }

    /**
     * Ce qui est demandé de cette scène. Voir {@link Reglages#pour}.
     *
     * @throws SceneFautive si une section de variante est refusée
     * @throws Echec si {@code --sans} nomme une variante qui n'existe pas
     */
    public Demande(SceneLue lue, Reglages reglages) {
        this(lue, reglages.pour(lue.variantes),
                new Scene(lue.objets, lue.lampes, lue.getCadrage(), reglages.pour(lue.variantes).getModele()));
        for (String type : reglages.get(Option.SANS)) {
            if (!LecteurSections.estUneVariante(type)) {
                throw Option.SANS.impossible(type, "une variante, par exemple Brume");
            }
        }
    }

    /** La même demande d'une autre lecture. @throws SceneFautive voir le constructeur */
    public Demande avecLecture(SceneLue autreLecture) {
        return new Demande(autreLecture, reglages);
    }

    /** @throws SceneFautive si un réglage est refusé */
    public Demande avecReglages(Reglages autresReglages) {
        return new Demande(lue, autresReglages, scene.avec(autresReglages.getModele()));
    }

    public Demande avecTaille(int autreLargeur, int autreHauteur) {
        return new Demande(lue, reglages.avec(Option.TAILLE, new Couple(autreLargeur, autreHauteur)), scene);
    }

    /** @param autreVue {@code null} pour l'image */
    public Demande avecVue(String autreVue) {
        return new Demande(lue, reglages.avec(Option.VUE, autreVue), scene);
    }

    /** La scène, ainsi réglée. Chaque appel en rend une nouvelle, à préparer. */
    public Scene getScene() {
        return scene.pourUnFil();
    }

    /** La commande qui demande la même chose. @param avant les options à écrire d'abord, chacune après un blanc */
    public String getCommande(String avant) {
        return Messages.commande(avant + reglages.getOptions(), lue.nom);
    }

    /** L'échec qui nomme un pixel dont le calcul a échoué, et la commande qui l'explique. */
    public Echec nommer(PixelFautif faute) {
        return Echec.machine("pixel " + faute.x + ", " + faute.y + " de " + Texte.echappe(lue.nom) + " : "
                + Cause.dire(faute) + " ; pour le revoir : "
                + getCommande(" --pixel " + Console.mot(faute.x + "," + faute.y)));
    }

    /** Deux demandes égales donnent la même image de la même lecture. */
    @Override
    public boolean equals(Object autre) {
        return autre instanceof Demande && lue == ((Demande) autre).lue && reglages.equals(((Demande) autre).reglages)
                && Objects.equals(vue, ((Demande) autre).vue);
    }

    @Override
    public int hashCode() {
        return reglages.hashCode();
    }
}
