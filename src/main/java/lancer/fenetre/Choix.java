package lancer.fenetre;

import lancer.commande.Reglages;
import lancer.scene.SceneLue;

/** Ce que l'on choisit dans la fenêtre et que Ctrl+Z défait : les déplacements, les réglages, la vue. Immuable. */
final class Choix {

    private final String fichier;
    /** La scène telle qu'elle est dans le fichier, puis avec les déplacements. */
    final SceneLue lue;
    final SceneLue scene;
    final Reglages reglages;
    /** La vue en fausses couleurs montrée à la place de l'image, ou {@code null}. */
    final String vue;

    Choix(String fichier, SceneLue lue, SceneLue scene, Reglages reglages, String vue) {
        this.fichier = fichier;
        this.lue = lue;
        this.scene = scene;
        this.reglages = reglages;
        this.vue = vue;
    }

    Choix avec(SceneLue autre) {
        return new Choix(fichier, lue, autre, reglages, vue);
    }

    Choix avec(Reglages autres) {
        return new Choix(fichier, lue, scene, autres, vue);
    }

    Choix avec(String autreVue) {
        return new Choix(fichier, lue, scene, reglages, autreVue);
    }

    /** Les mêmes choix pour une scène qui vient d'être relue, ou pour une autre, dont rien n'est déplacé. */
    Choix pour(Choix relu, boolean malgreLeFichier) {
        return relu.lue == lue ? this : new Choix(relu.fichier, relu.lue, relu.fichier.equals(fichier)
                ? relu.lue.reporter(lue, scene, malgreLeFichier) : relu.lue, reglages.pour(relu.lue.variantes), vue);
    }
}
