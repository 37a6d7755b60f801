package lancer.mesures.vitesse;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.Lancer;
import lancer.antialias.Antialias;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.contrat.Echantillonnage;
import lancer.mesures.Gabarit;

/** Une façon de dessiner, telle qu'un utilisateur la demande : un programme, une section de la scène, des options. Immuable. */
final class Reglage {

    static final String POVRAY = "POV-Ray";
    static final String EMBREE = "Embree";
    static final String PARTAGE = "partage";
    static final String COINS = "coins";
    static final String GRILLE = "grille";

    /** Le programme sans option : l'unité des temps. */
    static final Reglage UN_RAYON = new Reglage("un rayon", "", "lancer", "");

    /** Le module antialias, sur une scène qui n'a pas de section {@code [Antialias]}. */
    static final Reglage COINS_PAR_DEFAUT = new Reglage("coins par défaut", "", "antialias", "");
    static final Reglage BOUCLES = new Reglage("boucles du cours", "", "lancer", "", "--simple");

    /** Les options que « make » donne à la machine virtuelle d'une image. */
    static final Reglage MAKE = new Reglage("options de make", "", "lancer", "");

    private static final List<String> OPTIONS_DE_MAKE = Arrays.asList("-XX:+UseSerialGC", "-Xmn16m");

    /** Nom de la méthode et de ses paramètres ; vides s'il n'y en a pas. */
    final String methode;
    final String parametres;

    /** Ce que la section demande, dans ce processus. */
    private final Echantillonnage echantillonnage;

    /** Module dont le programme est lancé, section à ajouter à la scène, options de la commande. */
    final String module;
    final String section;
    final List<String> options;

    Reglage(String methode, String parametres, String module, String section, String... options) {
        this(methode, parametres, Lancer::TracerPave, module, section, options);
    }

    private Reglage(String methode, String parametres, Echantillonnage echantillonnage, String module, String section,
            String... options) {
        this.echantillonnage = echantillonnage;
        this.methode = methode;
        this.parametres = parametres;
        this.module = module;
        this.section = section;
        this.options = Collections.unmodifiableList(Arrays.asList(options));
    }

    static Reglage partage(int n, double seuil) {
        return new Reglage(PARTAGE, "n=" + n + " seuil=" + seuil, Antialias.partage(n, seuil), section(PARTAGE, n, seuil));
    }

    static Reglage coins(int n, double seuil) {
        return new Reglage(COINS, "n=" + n + " seuil=" + seuil, Antialias.coins(n, seuil), section(COINS, n, seuil));
    }

    static Reglage grille(int n) {
        return new Reglage(GRILLE, n + " × " + n, Antialias.coins(n, 0), section(COINS, n, 0));
    }

    private static String section(String methode, int n, double seuil) {
        return "[Antialias]\nmethode=" + methode + "\nn=" + n + "\nseuil=" + seuil + "\n";
    }

    private Reglage(String methode, String parametres, Echantillonnage echantillonnage, String section) {
        this(methode, parametres, echantillonnage, "antialias", section, "--reflets", String.valueOf(Gabarit.PROFONDEUR));
    }

    /** Le lancer qui dessine comme cette commande la scène de {@code prepare}. */
    Lancer lancer(Lancer prepare) {
        return prepare.avec(prepare.getScene().getModele().avec(echantillonnage, valeur(Option.SEUIL)));
    }

    int profondeur() {
        return valeur(Option.REFLETS);
    }

    private <T> T valeur(Option<T> option) {
        return Options.lire(options.toArray(new String[0])).get(option);
    }

    /** Le même dessin, par ces options au lieu des siennes. */
    Reglage par(String nom, String parametre, String... siennes) {
        return new Reglage(nom, parametre, echantillonnage, module, section, siennes);
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
