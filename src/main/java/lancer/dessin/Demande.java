package lancer.dessin;

import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.commande.Messages;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.contrat.Modele;
import lancer.contrat.PixelFautif;
import lancer.scene.LecteurSections;
import lancer.texte.Pile;
import lancer.texte.Texte;

/**
 * Ce qui est demandé : une scène lue, ses réglages, une taille, et une vue en fausses couleurs, ou l'image. Immuable.
 * Une méthode dont le nom commence par {@code avec} rend la même demande, à son argument près.
 */
public final class Demande {

    public final Lecture lecture;
    public final Reglages reglages;
    public final int largeur;
    public final int hauteur;
    /** Le nom de la vue ; {@code null} pour l'image. */
    public final String vue;
    private final Modele modele;

    private Demande(Lecture lecture, Reglages reglages, int largeur, int hauteur, String vue) {
        this.lecture = lecture;
        this.reglages = reglages;
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.vue = vue;
        modele = reglages.getModele();
    }

    /**
     * Ce que la ligne de commande demande de cette scène.
     *
     * @throws SceneFautive si une section de variante est refusée
     * @throws Echec si {@code --sans} nomme une variante qui n'existe pas
     */
    public Demande(Lecture lecture, Options options) {
        this(lecture, options.reglages.pour(lecture.lue.variantes), options.largeur, options.hauteur, options.vue);
        for (String type : reglages.getDebranchees()) {
            if (!LecteurSections.varianteConnue(type)
                    && reglages.getVariantes().stream().noneMatch(v -> v.getSection().equalsIgnoreCase(type))) {
                throw Echec.demande("valeur impossible pour --sans : " + Texte.cite(type)
                        + " ; attendu : une variante, par exemple Brume");
            }
        }
    }

    /** La même demande pour une autre lecture. Voir {@link Reglages#pour}. @throws SceneFautive voir le constructeur */
    public Demande avecLecture(Lecture autre) {
        return new Demande(autre, reglages.pour(autre.lue.variantes), largeur, hauteur, vue);
    }

    /** @throws SceneFautive si un réglage est refusé */
    public Demande avecReglages(Reglages autres) {
        return new Demande(lecture, autres, largeur, hauteur, vue);
    }

    public Demande avecTaille(int autreLargeur, int autreHauteur) {
        return new Demande(lecture, reglages, autreLargeur, autreHauteur, vue);
    }

    public Demande avecVue(String autre) {
        return new Demande(lecture, reglages, largeur, hauteur, autre);
    }

    /** La scène, ainsi réglée. Chaque appel en rend une nouvelle, à préparer. */
    public Scene getScene() {
        return lecture.scene.avec(modele);
    }

    /** La commande qui demande la même chose. @param avant les options à écrire d'abord, chacune après un blanc */
    public String getCommande(String avant) {
        return Messages.commande(avant, reglages.getOptions(), lecture.fichier, largeur, hauteur);
    }

    /** L'échec qui nomme un pixel dont le calcul a échoué, et la commande qui l'explique. */
    public Echec nommer(PixelFautif faute) {
        return Echec.machine("pixel " + faute.x + ", " + faute.y + " de " + Texte.echappe(lecture.fichier) + " : "
                + Pile.cause(faute, classes(getScene())) + " ; pour le revoir : "
                + getCommande(" --pixel " + faute.x + "," + faute.y));
    }

    /** Classes où situer un échec : celles des objets, de l'air et du reflet ; à défaut, toute autre qui calcule. */
    static String[] classes(Scene scene) {
        Modele modele = scene.getModele();
        return new String[] {Stream.concat(Stream.of(modele.getAtmosphere(), modele.getSpecularite()),
                scene.getObjets().stream()).map(Modele::nom).distinct().map(Pattern::quote)
                .collect(Collectors.joining("|")), "(?!lancer.(contrat|image|Main))" + Pile.HORS_DE_JAVA};
    }

    /** Deux demandes égales donnent la même image de la même lecture. */
    @Override
    public boolean equals(Object autre) {
        return autre instanceof Demande && cle().equals(((Demande) autre).cle());
    }

    @Override
    public int hashCode() {
        return cle().hashCode();
    }

    private List<Object> cle() {
        return Arrays.asList(lecture, reglages, largeur, hauteur, vue);
    }
}
