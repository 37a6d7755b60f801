package lancer.mesures.vitesse;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;
import lancer.mesures.FichierCsv;
import lancer.mesures.Gabarit;
import lancer.mesures.scenes.Scenes;

/** Besoins d'une scène : ses rayons, et les réflexions qui changent son image. Tout est compté, rien n'est chronométré. */
final class Besoin {

    static final List<String> COLONNES = Arrays.asList("scene", "largeur", "hauteur", "spheres", "lampes",
            "profondeur_utile", "tests_par_rayon", "rayons", "structures");

    private final Taille taille;
    private final String nom;
    private final Scene scene;
    private final Compteurs compteurs;

    /** Recherche qui a dessiné l'image, avec les structures qu'elle a construites. */
    private final Recherche recherche;

    Besoin(Path fichier, Taille taille) {
        this.taille = taille;
        nom = fichier.getFileName().toString().replace(".ini", "");
        scene = Scenes.lire(fichier);
        Lancer lancer = preparer(scene.avec(scene.getModele()), Constantes.SEUIL);
        codes(lancer, Constantes.MAX_REFLETS);
        compteurs = lancer.getCompteurs();
        recherche = lancer.getScene().getModele().getRecherche();
    }

    String ligne() {
        return FichierCsv.ligne(nom, taille.largeur, taille.hauteur, scene.getObjets().size(), scene.getLampes().size(),
                profondeurUtile(), Releve.reel((double) compteurs.testsSpheres / compteurs.rayons()),
                compteurs.rayons(), recherche == null ? "boucles" : recherche);
    }

    private Lancer preparer(Scene copie, double seuil) {
        copie.getModele().setSeuil(seuil);
        return Dessin.lancer(copie, taille.largeur, taille.hauteur, false);
    }

    private int[] codes(Lancer lancer, int profondeur) {
        ImageMemoire image = new ImageMemoire(taille.largeur, taille.hauteur, false);
        lancer.TracerPixels(image, profondeur, taille.fils);
        return image.codes;
    }

    /**
     * La plus petite profondeur qui donne les mêmes codes de pixels que mille réflexions, sans seuil. Chaque réflexion ajoute de la
     * lumière : l'image ne devient pas moins juste quand la profondeur augmente, et la recherche est dichotomique.
     */
    int profondeurUtile() {
        Lancer lancer = preparer(scene.avec(scene.getModele()), 0);
        int[] limite = codes(lancer, Gabarit.PROFONDEUR);
        int bas = 0;
        int haut = Gabarit.PROFONDEUR;
        while (bas < haut) {
            int milieu = (bas + haut) / 2;
            if (Arrays.equals(codes(lancer, milieu), limite)) {
                haut = milieu;
            } else {
                bas = milieu + 1;
            }
        }
        return bas;
    }
}
