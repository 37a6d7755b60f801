package lancer.mesures.vitesse;

import java.util.Collections;
import java.util.function.UnaryOperator;
import lancer.Constantes;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.auto.Auto;
import lancer.auto.Souhait;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Toile;
import lancer.contrat.Variante;
import lancer.fils.Traceur;
import lancer.temoins.LancerSurveille;

/** Une façon de dessiner une scène : ce qui se mesure. Sans rien de plus, celle du programme sans option. */
final class Methode {

    /** Ce que l'on fait, en un mot. */
    final String nom;

    /** Avec quoi ; vide s'il n'y a rien à choisir. */
    final String parametres;

    /** Celles de la commande, du programme ou de POV-Ray. */
    String[] options = {};

    /** Vrai pour les boucles du cours. */
    boolean boucles;

    boolean povray;

    private Echantillonnage echantillonnage = Echantillonnage.CENTRE;
    private int profondeur = Constantes.MAX_REFLETS;
    private double seuil = Constantes.SEUIL;
    private UnaryOperator<Scene> changement = UnaryOperator.identity();
    private double erreurVoulue;

    Methode(String nom, String parametres) {
        this.nom = nom;
        this.parametres = parametres;
    }

    Methode echantillonnee(Echantillonnage autre) {
        echantillonnage = autre;
        return this;
    }

    Methode limitee(int autreProfondeur, double autreSeuil) {
        profondeur = autreProfondeur;
        seuil = autreSeuil;
        return this;
    }

    /** Une fois la scène changée ainsi. */
    Methode sur(UnaryOperator<Scene> autre) {
        changement = autre;
        return this;
    }

    /** Par les boucles du cours. */
    Methode enBoucles() {
        boucles = true;
        options = new String[] {"--simple"};
        return this;
    }

    /** Ce que choisit {@code --auto} pour cette erreur ; ses essais ne sont pas du dessin. */
    Methode auto(double voulue) {
        erreurVoulue = voulue;
        return this;
    }

    Methode parPovRay(String... siennes) {
        povray = true;
        options = siennes;
        return this;
    }

    /** Ce qui la distingue des autres sur une même scène. */
    String cle() {
        return nom + "/" + parametres;
    }

    /** Une scène prête. */
    final class Dessin {

        /** Ce qui a été choisi, si c'était à choisir. */
        final String choix;
        final Traceur lancer;
        private final int reflets;

        Dessin(Scene lue, int largeur, int hauteur) {
            Scene changee = changement.apply(lue);
            Scene scene = changee.avec(changee.getModele().avec(echantillonnage, seuil));
            Traceur prepare = LancerSurveille.preparer(scene, largeur, hauteur, boucles);
            if (erreurVoulue > 0) {
                Auto auto = Auto.choisir(prepare, Souhait.erreur(erreurVoulue), Runtime.getRuntime().availableProcessors(),
                        Collections.<Variante>singletonList(new Antialias()), enCours -> { });
                lancer = auto.getTraceur();
                reflets = auto.getChoisi().reflets;
                choix = auto.getChoisi().toString();
            } else {
                lancer = prepare;
                reflets = profondeur;
                choix = "";
            }
        }

        /** Une fois, par le chemin du programme. */
        void faire(Toile toile, int fils) {
            lancer.TracerPixels(toile, reflets, fils);
        }

        /** Par les boucles du cours, ce que garde {@code filtre} du même échantillonnage. */
        void refaire(UnaryOperator<Echantillonnage> filtre, Toile toile, int fils) {
            Scene scene = lancer.getScene();
            Echantillonnage partiel = filtre.apply(scene.getModele().getEchantillonnage());
            Scene partielle = scene.avec(scene.getModele().avec(partiel, scene.getModele().getSeuil()));
            LancerSurveille.preparer(partielle, lancer.getCamera().getLargeur(), lancer.getCamera().getHauteur(), true)
                    .parcourir(partiel, toile, reflets, fils);
        }
    }
}
