package lancer.mesures.vitesse;

import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Toile;
import lancer.dessin.Dessin;

/** Une méthode de dessin à mesurer ; par défaut, celle du programme sans option. */
final class Methode {

    final String nom;

    /** Paramètres ; vide s'il n'y en a pas. */
    final String parametres;

    /** Options de la commande, du programme ou de POV-Ray. */
    String[] options = {};

    /** Options de la machine virtuelle du programme. */
    List<String> machine = Collections.emptyList();

    /** Section à ajouter à la scène ; vide s'il n'en faut pas. */
    String section = "";

    /** Module dont le programme est lancé. */
    String module = "lancer";

    /** Vrai pour les boucles du cours. */
    boolean boucles;

    boolean povray;

    private Echantillonnage echantillonnage;
    private int profondeur = Constantes.MAX_REFLETS;
    private double seuil = Constantes.SEUIL;
    private Consumer<Modele> variante = modele -> { };

    Methode(String nom, String parametres) {
        this.nom = nom;
        this.parametres = parametres;
    }

    /** @param laquelle {@code coins} ou {@code partage} */
    Methode echantillonnee(String laquelle, int n, double contraste) {
        sansSection(laquelle.equals("partage") ? Antialias.partage(n, contraste) : Antialias.coins(n, contraste));
        section = "[Antialias]\nmethode=" + laquelle + "\nn=" + n + "\nseuil=" + contraste + "\n";
        return this;
    }

    /** @param sienne ce que le module antialias installe dans une scène qui ne lui demande rien */
    Methode sansSection(Echantillonnage sienne) {
        echantillonnage = sienne;
        module = "antialias";
        return this;
    }

    Methode limitee(int autreProfondeur, double autreSeuil) {
        profondeur = autreProfondeur;
        seuil = autreSeuil;
        options = ("--reflets " + profondeur + (seuil == Constantes.SEUIL ? "" : " --seuil " + seuil)).split(" ");
        return this;
    }

    /** La même méthode, par le programme de cette variante, qui s'installe ainsi. */
    Methode variante(String sonModule, Consumer<Modele> installation) {
        module = sonModule;
        variante = installation;
        return this;
    }

    /** La même méthode, par les boucles du cours. */
    Methode enBoucles() {
        boucles = true;
        options = new String[] {"--simple"};
        return this;
    }

    /** Le choix automatique du programme. */
    Methode automatique() {
        module = "antialias";
        options = new String[] {nom, parametres};
        return this;
    }

    Methode parPovRay(String... siennes) {
        povray = true;
        options = siennes;
        return this;
    }

    /** Clé unique de la méthode pour une scène. */
    String cle() {
        return nom + "/" + parametres;
    }

    /** Chemin, depuis la racine, du programme à lancer. */
    String jar() {
        return (module.equals("lancer") ? "" : module + "/") + "target/" + module + ".jar";
    }

    /** La commande que l'utilisateur écrit. */
    String commande() {
        return ("java -jar " + jar() + " " + String.join(" ", options)).trim() + " --image boules.png scenes/scene1.ini";
    }

    final class ScenePrete {

        final Lancer lancer;

        ScenePrete(Scene lue, int largeur, int hauteur) {
            Modele modele = lue.getModele().avec(echantillonnage, seuil);
            variante.accept(modele);
            lancer = Dessin.lancer(lue.avec(modele), largeur, hauteur, boucles);
        }

        /** Dessine une fois, comme le programme. */
        Compteurs faire(Toile toile, int fils) {
            lancer.TracerPixels(toile, profondeur, fils);
            return lancer.getCompteurs();
        }

        /** Refait, par les boucles du cours, la partie de l'échantillonnage que garde {@code filtre}. */
        void refaire(UnaryOperator<Echantillonnage> filtre, Toile toile, int fils) {
            Scene scene = lancer.getScene();
            Echantillonnage sien = scene.getModele().getEchantillonnage();
            Echantillonnage partiel = filtre.apply(sien == null ? Antialias.coins(1, 0) : sien.pour(scene.getObjets(), lancer.getCamera()));
            Dessin.lancer(scene.avec(scene.getModele().avec(partiel, seuil)), lancer.getCamera().getLargeur(),
                    lancer.getCamera().getHauteur(), true).TracerPixels(toile, profondeur, fils);
        }
    }
}
