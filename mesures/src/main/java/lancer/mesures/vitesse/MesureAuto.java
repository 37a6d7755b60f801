package lancer.mesures.vitesse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import java.util.Locale;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.atelier.FichierCsv;
import lancer.atelier.SceneAuHasard;
import lancer.atelier.Scenes;
import lancer.auto.Auto;
import lancer.auto.Reglage;
import lancer.auto.Souhait;
import lancer.contrat.Variante;
import lancer.fils.Traceur;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.dessin.LancerSurveille;
import lancer.texte.Texte;

/**
 * {@code --auto erreur=E} tient-il parole ? Sur les scènes livrées et sur cent scènes tirées au sort, l'erreur de l'image choisie,
 * contre la vérité, le prix annoncé et celui des essais.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.mesures.vitesse.MesureAuto FICHIER.csv [GRAINE COMBIEN]
 * </pre>
 */
public final class MesureAuto {

    static final String COLONNES = "scene,erreur_voulue,reglage,promise,erreur_attendue,erreur_au_plus,erreur,tenue,rayons_attendus,"
            + "rayons,rayons_des_essais,part_des_essais";

    static final Taille TAILLE = new Taille(200, 150);
    private static final double[] ERREURS = {0.5, 1, 2, 4};

    private static final int GRAINE = 1;
    private static final int SCENES = 100;

    private MesureAuto() {
    }

    /** @param args le fichier, écrit à la fin ; la première graine et combien de scènes au sort, si l'on en veut d'autres */
    public static void main(String[] args) {
        try {
            int graine = args.length > 1 ? Integer.parseInt(args[1]) : GRAINE;
            mesurer(Paths.get(args[0]), graine, graine + (args.length > 2 ? Integer.parseInt(args[2]) : SCENES));
        } catch (IllegalArgumentException | ArrayIndexOutOfBoundsException e) {
            System.err.println("MesureAuto : " + e.getMessage() + " ; usage : MesureAuto FICHIER.csv [GRAINE COMBIEN]");
            System.exit(2);
        } catch (IOException e) {
            System.err.println("MesureAuto : " + args[0] + " : " + Texte.panne(e));
            System.exit(1);
        }
    }

    private static void mesurer(Path csv, int graine, int fin) throws IOException {
        StringBuilder lignes = new StringBuilder(COLONNES);
        for (Path fichier : Scenes.livrees()) {
            mesurer(lignes, fichier.getFileName().toString().replace(".ini", ""), Scenes.lire(fichier));
        }
        for (int k = graine; k < fin; k++) {
            mesurer(lignes, "sort-" + k, SceneAuHasard.de(k));
        }
        Files.write(csv, Collections.singletonList(lignes));
        Rapport.promesses(FichierCsv.lire(csv)).forEach((nom, valeur) -> System.out.println(nom + " : " + valeur));
        System.out.println("noté dans " + csv);
    }

    private static void mesurer(StringBuilder lignes, String nom, Scene scene) {
        Gabarit gabarit = new Gabarit(scene, TAILLE.largeur, TAILLE.hauteur, 1);
        for (double voulue : ERREURS) {
            lignes.append('\n').append(ligne(nom, scene, TAILLE, gabarit, voulue));
        }
    }

    /** Ce que le programme a promis pour cette scène, et ce qu'il en est. */
    static String ligne(String nom, Scene scene, Taille taille, Gabarit gabarit, double voulue) {
        Auto auto = Auto.choisir(LancerSurveille.preparer(scene, taille.largeur, taille.hauteur, false), Souhait.erreur(voulue),
                taille.fils, Collections.<Variante>singletonList(new Antialias()), enCours -> { });
        Reglage choisi = auto.getChoisi();
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        Traceur lancer = auto.getTraceur();
        lancer.TracerPixels(auto.surveiller(image, choisi), choisi.reflets, taille.fils);
        auto.controler();
        double rayons = (double) lancer.getCompteurs().rayons() / taille.pixels();
        double essais = (double) auto.getRayonsDesEssais() / taille.pixels();
        double erreur = Intervalle.deLaRacine(gabarit.carres(image)).valeur;
        return FichierCsv.ligne(nom, voulue, choisi, ouiNon(auto.estTenable()), nombre(choisi.erreur), nombre(choisi.erreurAuPlus),
                nombre(erreur), ouiNon(erreur <= voulue), nombre(choisi.prix), nombre(rayons), nombre(essais), nombre(essais / rayons));
    }

    private static String ouiNon(boolean vrai) {
        return vrai ? "oui" : "non";
    }

    private static String nombre(double x) {
        return String.format(Locale.ROOT, "%.3f", x);
    }
}
