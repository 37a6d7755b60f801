package lancer.mesures.vitesse;

import java.nio.file.Path;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Toile;
import lancer.dessin.Dessin;

/** Une méthode de dessin à mesurer ; par défaut, celle du programme sans option. */
final class Methode {

    final String nom;

    /** Paramètres ; vide s'il n'y en a pas. */
    final String parametres;

    /** Options de la commande, du programme ou de POV-Ray. */
    String[] options = {};

    /** Section {@code [Antialias]} à ajouter à la scène ; vide s'il n'en faut pas. */
    String section = "";

    /** Vrai pour le programme avec l'anticrénelage. */
    boolean antialias;

    /** Vrai pour les boucles du cours. */
    boolean boucles;

    boolean povray;

    /** Un autre programme que celui-ci, ou {@code null}. */
    Path jar;

    private Echantillonnage echantillonnage;
    private int profondeur = Constantes.MAX_REFLETS;
    private double seuil = Constantes.SEUIL;
    private UnaryOperator<Scene> changement = UnaryOperator.identity();

    Methode(String nom, String parametres) {
        this.nom = nom;
        this.parametres = parametres;
    }

    /** @param laquelle {@code coins} ou {@code partage} */
    Methode echantillonnee(String laquelle, int n, double contraste) {
        echantillonnage = laquelle.equals(Catalogue.PARTAGE) ? Antialias.partage(n, contraste) : Antialias.coins(n, contraste);
        section = "[Antialias]\nmethode=" + laquelle + "\nn=" + n + "\nseuil=" + contraste + "\n";
        antialias = true;
        return this;
    }

    Methode limitee(int autreProfondeur, double autreSeuil) {
        profondeur = autreProfondeur;
        seuil = autreSeuil;
        options = ("--reflets " + profondeur + (seuil == Constantes.SEUIL ? "" : " --seuil " + seuil)).split(" ");
        return this;
    }

    /** Ce que l'utilisateur doit écrire dans la scène, puis dans la commande. */
    String ecrit() {
        return Stream.of(section.trim().replace('\n', ' '), String.join(" ", options)).filter(s -> !s.isEmpty())
                .map(s -> "`" + s + "`").collect(Collectors.joining(", "));
    }

    /** La même méthode, sur la scène ainsi changée. */
    Methode sur(UnaryOperator<Scene> autre) {
        changement = autre;
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
        antialias = true;
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

    final class ScenePrete {

        final Lancer lancer;

        ScenePrete(Scene lue, int largeur, int hauteur) {
            Scene changee = changement.apply(lue);
            lancer = Dessin.lancer(changee.avec(changee.getModele().avec(echantillonnage, seuil)), largeur, hauteur, boucles);
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
