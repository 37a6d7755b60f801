package lancer.mesures.vitesse;

import java.util.function.UnaryOperator;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Toile;
import lancer.temoins.LancerSurveille;

/** Une façon de dessiner une scène : ce qui se mesure. Immuable : chaque précision en donne une autre. */
final class Methode {

    final Famille famille;

    /** Ce que l'on fait, en un mot. */
    final String nom;

    /** Avec quoi ; vide s'il n'y a rien à choisir. */
    final String parametres;

    private final Echantillonnage echantillonnage;
    private final int profondeur;
    private final double seuil;
    private final UnaryOperator<Scene> changement;
    private final boolean brouillon;
    private final boolean lisible;
    private final boolean parPaves;

    private Methode(Famille famille, String nom, String parametres, Echantillonnage echantillonnage, int profondeur, double seuil,
            UnaryOperator<Scene> changement, boolean brouillon, boolean lisible, boolean parPaves) {
        this.famille = famille;
        this.nom = nom;
        this.parametres = parametres;
        this.echantillonnage = echantillonnage;
        this.profondeur = profondeur;
        this.seuil = seuil;
        this.changement = changement;
        this.brouillon = brouillon;
        this.lisible = lisible;
        this.parPaves = parPaves;
    }

    /** Comme le programme sans option : un rayon par pixel, les limites de réflexion par défaut. */
    static Methode de(Famille famille, String nom, String parametres) {
        return new Methode(famille, nom, parametres, Echantillonnage.CENTRE, Constantes.MAX_REFLETS, Constantes.SEUIL,
                UnaryOperator.identity(), false, false, false);
    }

    Methode echantillonnee(Echantillonnage autre) {
        return new Methode(famille, nom, parametres, autre, profondeur, seuil, changement, brouillon, lisible, parPaves);
    }

    /** Avec un échantillonnage où des pixels voisins partagent des rayons, à l'intérieur d'un pavé. */
    Methode partagee(Echantillonnage autre) {
        return new Methode(famille, nom, parametres, autre, profondeur, seuil, changement, brouillon, lisible, true);
    }

    Methode limitee(int autreProfondeur, double autreSeuil) {
        return new Methode(famille, nom, parametres, echantillonnage, autreProfondeur, autreSeuil, changement, brouillon, lisible,
                parPaves);
    }

    /** Une fois la scène changée ainsi. */
    Methode sur(UnaryOperator<Scene> autreChangement) {
        return new Methode(famille, nom, parametres, echantillonnage, profondeur, seuil, autreChangement, brouillon, lisible, parPaves);
    }

    /** Le brouillon de la fenêtre, au lieu de l'image. */
    Methode enBrouillon() {
        return new Methode(famille, nom, parametres, echantillonnage, profondeur, seuil, changement, true, lisible, parPaves);
    }

    /** Par les boucles du cours. */
    Methode lisible() {
        return new Methode(famille, nom, parametres, echantillonnage, profondeur, seuil, changement, brouillon, true, parPaves);
    }

    /** Ce qui la distingue des autres sur une même scène. */
    String cle() {
        return famille.nom() + "/" + nom + "/" + parametres;
    }

    /** Vrai si un pixel n'y dépend pas de ses voisins. */
    boolean pixelParPixel() {
        return !brouillon && !parPaves;
    }

    boolean estBrouillon() {
        return brouillon;
    }

    boolean estLisible() {
        return lisible;
    }

    Echantillonnage getEchantillonnage() {
        return echantillonnage;
    }

    /** Prépare cette scène, qui n'est pas changée, par le chemin du programme. */
    Lancer preparer(Scene scene, int largeur, int hauteur) {
        return preparer(scene, largeur, hauteur, echantillonnage, lisible);
    }

    /** La même image par les boucles du cours, avec cet échantillonnage-là. */
    Lancer preparerLisible(Scene scene, int largeur, int hauteur, Echantillonnage autre) {
        return preparer(scene, largeur, hauteur, autre, true);
    }

    private Lancer preparer(Scene scene, int largeur, int hauteur, Echantillonnage choisi, boolean boucles) {
        return LancerSurveille.preparer(changement.apply(scene).avec(choisi, seuil), largeur, hauteur, boucles);
    }

    /** Dessine, une fois. */
    void dessiner(Lancer lancer, Toile toile, int fils) {
        if (brouillon) {
            lancer.TracerBrouillon(toile, profondeur, fils);
        } else {
            lancer.TracerPixels(toile, profondeur, fils);
        }
    }
}
