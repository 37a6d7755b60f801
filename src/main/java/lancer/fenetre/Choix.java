package lancer.fenetre;

import lancer.dessin.ReglagesDessin;
import lancer.scene.SceneLue;

/** Ce que l'on choisit dans la fenêtre et que Ctrl+Z défait : les déplacements, les réglages, la vue. Immuable. */
final class Choix {

    private final String fichier;
    /** La scène telle qu'elle est dans le fichier, et les réglages de la ligne de commande et de ce fichier. */
    final SceneLue lue;
    private final ReglagesDessin initiaux;
    /** La scène avec les déplacements, et les réglages choisis. */
    final SceneLue scene;
    final ReglagesDessin reglages;
    /** La vue en fausses couleurs montrée à la place de l'image, ou {@code null}. */
    final String vue;

    /** Ce que disent le fichier et la ligne de commande. */
    Choix(String fichier, SceneLue lue, ReglagesDessin initiaux) {
        this(fichier, lue, initiaux, lue, initiaux, null);
    }

    private Choix(String fichier, SceneLue lue, ReglagesDessin initiaux, SceneLue scene, ReglagesDessin reglages,
            String vue) {
        this.fichier = fichier;
        this.lue = lue;
        this.initiaux = initiaux;
        this.scene = scene;
        this.reglages = reglages;
        this.vue = vue;
    }

    Choix avec(SceneLue autre) {
        return new Choix(fichier, lue, initiaux, autre, reglages, vue);
    }

    Choix avec(ReglagesDessin autres) {
        return new Choix(fichier, lue, initiaux, scene, autres, vue);
    }

    Choix avec(String autreVue) {
        return new Choix(fichier, lue, initiaux, scene, reglages, autreVue);
    }

    /** Les mêmes choix pour une scène qui vient d'être relue, ou pour une autre, dont rien n'est déplacé. */
    Choix pour(Choix relu, boolean malgreLeFichier) {
        return relu.lue == lue ? this : new Choix(relu.fichier, relu.lue, relu.initiaux, relu.fichier.equals(fichier)
                ? relu.lue.reporter(lue, scene, malgreLeFichier) : relu.lue,
                reglages.pour(relu.initiaux), vue);
    }

    /** Vrai si quelque chose de déplacé n'est pas dans le fichier. */
    boolean estDeplace() {
        return scene != lue;
    }
}
