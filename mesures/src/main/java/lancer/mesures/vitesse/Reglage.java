package lancer.mesures.vitesse;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.mesures.Gabarit;

/** Une façon de dessiner, telle qu'un utilisateur la demande : un programme, une section de la scène, des options. Immuable. */
final class Reglage {

    static final String POVRAY = "POV-Ray";
    static final String EMBREE = "Embree";
    static final String PARTAGE = "partage";
    static final String COINS = "coins";
    static final String GRILLE = "grille";
    static final String AUTO = "--auto";

    /** Le programme sans option : l'unité des temps. */
    static final Reglage UN_RAYON = new Reglage("un rayon", "", "lancer", "");

    /** Le module antialias, sur une scène qui n'a pas de section {@code [Antialias]}. */
    static final Reglage COINS_PAR_DEFAUT = new Reglage("coins par défaut", "", "antialias", "");
    static final Reglage BOUCLES = new Reglage("boucles du cours", "", "lancer", "", "--simple");

    /** Les options que « make » donne à la machine virtuelle d'une image. */
    static final Reglage MAKE = new Reglage("options de make", "", "lancer", "");

    private static final List<String> OPTIONS_DE_MAKE = Arrays.asList("-XX:+UseSerialGC", "-Xmn16m");

    /** Où les reflets sont suivis jusqu'au produit des Ks que l'on peut conseiller. */
    private static final String[] TOUS_LES_REFLETS = {"--reflets", String.valueOf(Gabarit.PROFONDEUR), "--seuil", "0.0078125"};

    /** Nom de la méthode et de ses paramètres ; vides s'il n'y en a pas. */
    final String methode;
    final String parametres;

    /** Module dont le programme est lancé, section à ajouter à la scène, options de la commande. */
    final String module;
    final String section;
    final List<String> options;

    Reglage(String methode, String parametres, String module, String section, String... options) {
        this.methode = methode;
        this.parametres = parametres;
        this.module = module;
        this.section = section;
        this.options = Collections.unmodifiableList(Arrays.asList(options));
    }

    static Reglage partage(int n, double seuil) {
        return antialias(PARTAGE, "n=" + n + " seuil=" + seuil, PARTAGE, n, seuil);
    }

    static Reglage coins(int n, double seuil) {
        return antialias(COINS, "n=" + n + " seuil=" + seuil, COINS, n, seuil);
    }

    static Reglage grille(int n) {
        return antialias(GRILLE, n + " × " + n, COINS, n, 0);
    }

    private static Reglage antialias(String nom, String parametres, String methode, int n, double seuil) {
        return new Reglage(nom, parametres, "antialias", "[Antialias]\nmethode=" + methode + "\nn=" + n + "\nseuil=" + seuil + "\n",
                TOUS_LES_REFLETS);
    }

    static Reglage auto(int erreur) {
        return new Reglage(AUTO, "erreur=" + erreur, "antialias", "", AUTO, "erreur=" + erreur);
    }

    /** Le même dessin, par ces options au lieu des siennes. */
    Reglage par(String nom, String parametre, String... siennes) {
        return new Reglage(nom, parametre, module, section, siennes);
    }

    String nom() {
        return (methode + " " + parametres).trim();
    }

    /** Options de la machine virtuelle. */
    List<String> machine() {
        return this == MAKE ? OPTIONS_DE_MAKE : Collections.emptyList();
    }

    /** Chemin, depuis la racine, du programme à lancer. */
    String jar() {
        return (module.equals("lancer") ? "" : module + "/") + "target/" + module + ".jar";
    }

    /** La commande que l'utilisateur écrit. */
    String commande() {
        return ("java -jar " + jar() + " " + String.join(" ", options)).trim() + " --image boules.png scenes/scene1.ini";
    }
}
