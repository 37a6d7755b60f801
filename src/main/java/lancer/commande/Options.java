package lancer.commande;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Scanner;
import lancer.Constantes;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/** La ligne de commande, lue de gauche à droite. Une demande fausse est refusée par un {@link Echec}. */
public final class Options {

    private static final int COTE_MAX = 16384;
    private static final int PIXELS_MAX = 100_000_000;
    private static final int FILS_MAX = 1024;
    public static final int REFLETS_MAX = 1000;

    /** Options à valeur, chacune avec la valeur attendue. */
    private static final String[][] A_VALEUR = {
        {"--image", "un fichier dont le nom finit par .png"},
        {"--lineaire", "un fichier dont le nom finit par .pfm"},
        {"--taille", "LARGEURxHAUTEUR, par exemple 800x600, de 1 à " + COTE_MAX + " chacune, et au plus " + PIXELS_MAX
                + " pixels"},
        {"--reflets", "un entier de 0 à 1000"},
        {"--etape", "une étape du cours : lambert, phong, ombres ou reflets"},
        {"--vue", "une vue : normales, distance, lampes, rayons ou difference"},
        {"--seuil", "un nombre positif ou nul, par exemple 0.001"},
        {"--sans", "des noms de variantes séparés par une virgule, par exemple Brume,Blinn"},
        {"--fils", "un entier de 1 à " + FILS_MAX},
        {"--repeter", "un entier de 1 à 100000"},
        {"--pixel", "X,Y, colonne et ligne d'un pixel depuis le coin en haut à gauche, par exemple 421,426"},
        {"--auto", "erreur=E, de 0.01 à 255 niveaux, par exemple erreur=1"},
        {"--comparer", "une image PNG ou PFM"},
        {"--tolerance", "un nombre de niveaux positif ou nul, par exemple 1"},
        {"--part", "une part des pixels, de 0 à 1 ou de 0% à 100%, par exemple 0.5%"}};
    private static final List<String> SANS_VALEUR =
            Arrays.asList("--statistiques", "--simple", "--aide", "--help", "-h", "--version");

    public static final List<String> VUES = Collections.unmodifiableList(
            Arrays.asList("normales", "distance", "lampes", "rayons", "difference"));

    /** Demandes d'un texte seul ; la première l'emporte. */
    public boolean aide;
    public boolean version;

    /** Fichiers à écrire, ou {@code null}. */
    public String image;
    public String lineaire;

    public int largeur = Constantes.LARGEUR_IMAGE;
    public int hauteur = Constantes.HAUTEUR_IMAGE;
    public Reglages reglages;

    /** La vue en fausses couleurs à écrire ; {@code null} pour l'image. */
    public String vue;
    public int fils = Math.min(FILS_MAX, Runtime.getRuntime().availableProcessors());
    public int repeter = 1;
    public boolean statistiques;

    /** Dit si un seul pixel est demandé ; sa colonne et sa ligne. */
    public boolean pixel;
    public int pixelX;
    public int pixelY;

    /** Dit si le programme choisit ses réglages ; erreur voulue, en niveaux. */
    public boolean auto;
    public double erreurVoulue;

    /** Image de référence, ou {@code null} ; écart permis, en niveaux ; part des pixels, de 0 à 1, qui le passe. */
    public String comparer;
    public double tolerance;
    public double part;

    /** La scène, {@code null} si aucune n'est nommée. */
    public String scene;

    /** Chaque option donnée, et sa valeur, vide si elle n'en a pas. */
    private final Map<String, String> donnees = new HashMap<>();

    private Options() {
    }

    /** @throws Echec si un argument est refusé */
    public static Options lire(String... arguments) {
        Options options = new Options();
        options.separer(arguments);
        options.comprendre();
        if (!options.aide && !options.version) {
            options.accorder();
        }
        return options;
    }

    public static String getAide() {
        try (Scanner texte = new Scanner(Options.class.getResourceAsStream("aide.txt"), "UTF-8")) {
            return texte.useDelimiter("\\n\\z").next();
        }
    }

    public static String getVersion() {
        String version = Options.class.getPackage().getImplementationVersion();
        return "lancer " + (version != null ? version : "(non empaqueté)");
    }

    /** Dit si la demande (fichier, pixel, comparaison) se fait sans fenêtre. */
    public boolean sansFenetre() {
        return versFichier() || pixel || comparer != null;
    }

    private boolean versFichier() {
        return image != null || lineaire != null;
    }

    public boolean estDonnee(String nom) {
        return donnees.containsKey(nom);
    }

    /** Dit si ce nom est celui d'une image à comparer, et non d'une scène. */
    public static boolean estImage(String nom) {
        return finit(nom, ".png") || finit(nom, ".pfm");
    }

    /** Examine le nom donné, et non le fichier où mène un lien. */
    private static boolean finit(String nom, String fin) {
        return Texte.minuscules(nom).endsWith(fin);
    }

    private void separer(String... arguments) {
        for (int k = 0; k < arguments.length && !aide && !version; k++) {
            String argument = arguments[k];
            if (!argument.startsWith("-")) {
                nommerLaScene(argument);
                continue;
            }
            int egal = argument.startsWith("--") ? argument.indexOf('=') : -1;
            String nom = egal < 0 ? argument : argument.substring(0, egal);
            String valeur = egal < 0 ? "" : argument.substring(egal + 1);
            if (attendue(nom) != null) {
                // dans « --image --fils 2 », le nom du fichier a été oublié
                if (egal < 0 && k + 1 < arguments.length && !arguments[k + 1].startsWith("--")) {
                    valeur = arguments[++k];
                }
            } else if (!SANS_VALEUR.contains(nom)) {
                throw demande("option inconnue : " + Texte.cite(nom), "une de celles que montre --aide");
            } else if (egal >= 0) {
                throw Echec.demande("option qui ne prend pas de valeur : " + nom + " ; reçu : " + Texte.cite(valeur));
            }
            if (donnees.put(nom, valeur) != null) {
                throw demande("option donnée deux fois : " + nom, "une seule fois chaque option");
            }
            aide = nom.equals("--aide") || nom.equals("--help") || nom.equals("-h");
            version = nom.equals("--version");
        }
    }

    /** La valeur que cette option attend ; {@code null} si elle n'en a pas. */
    private static String attendue(String nom) {
        for (String[] option : A_VALEUR) {
            if (option[0].equals(nom)) {
                return option[1];
            }
        }
        return null;
    }

    private void nommerLaScene(String nom) {
        if (scene != null) {
            throw demande("plusieurs scènes : " + Texte.cite(scene) + " et " + Texte.cite(nom), "une seule");
        }
        if (nom.isEmpty()) {
            throw demande("nom de scène vide", "un fichier, par exemple scenes/scene1.ini");
        }
        scene = nom;
    }

    private void comprendre() {
        image = valeur("--image");
        exiger(image == null || finit(image, ".png"), "--image");
        lineaire = valeur("--lineaire");
        exiger(lineaire == null || finit(lineaire, ".pfm"), "--lineaire");
        String taille = valeur("--taille");
        if (taille != null) {
            double[] cotes = deuxEntiers(taille, 'x');
            exiger(Math.min(cotes[0], cotes[1]) >= 1 && Math.max(cotes[0], cotes[1]) <= COTE_MAX
                    && cotes[0] * cotes[1] <= PIXELS_MAX, "--taille");
            largeur = (int) cotes[0];
            hauteur = (int) cotes[1];
        }
        Etape etape = Etape.REFLETS;
        String nom = valeur("--etape");
        for (Etape celle : Etape.values()) {
            etape = celle.toString().equals(nom) ? celle : etape;
        }
        exiger(nom == null || etape.toString().equals(nom), "--etape");
        String variantes = valeur("--sans");
        List<String> sans = variantes == null ? Collections.<String>emptyList()
                : Arrays.asList(variantes.split(",", -1));
        exiger(!sans.contains(""), "--sans");
        reglages = new Reglages(etape, entier("--reflets", Constantes.MAX_REFLETS, 0, REFLETS_MAX),
                positif("--seuil", Constantes.SEUIL), estDonnee("--simple"), sans);
        vue = valeur("--vue");
        exiger(vue == null || VUES.contains(vue), "--vue");
        fils = entier("--fils", fils, 1, FILS_MAX);
        repeter = entier("--repeter", repeter, 1, 100_000);
        statistiques = estDonnee("--statistiques");
        String xy = valeur("--pixel");
        pixel = xy != null;
        if (pixel) {
            double[] lus = deuxEntiers(xy, ',');
            exiger(Math.min(lus[0], lus[1]) >= 0, "--pixel");
            pixelX = (int) lus[0];
            pixelY = (int) lus[1];
        }
        String souhait = valeur("--auto");
        auto = souhait != null;
        if (auto) {
            erreurVoulue = souhait.startsWith("erreur=") ? Nombre.lire(souhait.substring("erreur=".length())) : 0;
            exiger(erreurVoulue >= 0.01 && erreurVoulue <= 255, "--auto");
        }
        comparer = valeur("--comparer");
        exiger(comparer == null || estImage(comparer), "--comparer");
        tolerance = positif("--tolerance", tolerance);
        String portion = valeur("--part");
        if (portion != null) {
            boolean pourCent = portion.endsWith("%");
            String nombre = pourCent ? portion.substring(0, portion.length() - 1) : portion;
            part = Nombre.lire(nombre);
            // pour que 0.7 % donne exactement 0.007 : une division l'arrondirait autrement
            part = pourCent && part >= 0 && part <= 100 ? new BigDecimal(nombre).movePointLeft(2).doubleValue() : part;
        }
        exiger(part >= 0 && part <= 1, "--part");
    }

    private void accorder() {
        if (pixel) {
            refuser("--pixel ne va pas avec %s", "--image", "--lineaire", "--auto", "--repeter", "--comparer");
            if (pixelX >= largeur || pixelY >= hauteur) {
                throw impossible("--pixel", "un pixel de l'image, de 0,0 à " + (largeur - 1) + "," + (hauteur - 1));
            }
        }
        if (comparer != null) {
            if (scene == null) {
                throw demande("rien à comparer à " + Texte.cite(comparer), "une scène, ou une image PNG ou PFM");
            }
            refuser("%s ne va pas avec --comparer", "--taille", "--lineaire", "--repeter", "--statistiques", "--auto");
        }
        if (vue != null) {
            refuser("--vue ne va pas avec %s", "--lineaire", "--auto", "--pixel", "--repeter");
            if (image == null) {
                throw demande("--vue ne sert pas seule", "avec elle, --image FICHIER.png");
            }
            if (comparer != null && !vue.equals("difference")) {
                throw demande("--vue " + vue + " ne va pas avec --comparer", "--vue difference");
            }
        }
        for (String nom : new String[] {"--tolerance", "--part"}) {
            if (comparer == null && estDonnee(nom)) {
                throw demande(nom + " ne sert pas seule", "avec elle, --comparer REFERENCE.png");
            }
        }
        if ((versFichier() || pixel) && scene == null) {
            throw demande("aucune scène à dessiner", "un fichier, par exemple scenes/scene1.ini");
        }
        if (auto && !versFichier()) {
            throw demande("--auto ne sert pas dans la fenêtre",
                    "avec elle, --image FICHIER.png ou --lineaire FICHIER.pfm");
        }
    }

    private void refuser(String faute, String... autres) {
        for (String autre : autres) {
            if (estDonnee(autre)) {
                throw demande(String.format(faute, autre), "l'une ou l'autre");
            }
        }
    }

    /** La valeur de cette option, {@code null} si l'option n'est pas donnée. */
    private String valeur(String nom) {
        String valeur = donnees.get(nom);
        if (valeur != null && valeur.isEmpty()) {
            throw demande("option sans sa valeur : " + nom, attendue(nom));
        }
        return valeur;
    }

    private int entier(String nom, int defaut, int min, int max) {
        String texte = valeur(nom);
        double n = texte == null ? defaut : chiffres(texte);
        exiger(n >= min && n <= max, nom);
        return (int) n;
    }

    private double positif(String nom, double defaut) {
        String texte = valeur(nom);
        double n = texte == null ? defaut : Nombre.lire(texte);
        exiger(n >= 0 && n <= Double.MAX_VALUE, nom);
        return n;
    }

    /** L'entier écrit, quelle que soit sa taille ; -1 si le texte n'en est pas un. */
    private static double chiffres(String texte) {
        // pas d'expression régulière : voir docs/etendre.md
        for (char c : texte.toCharArray()) {
            if (c < '0' || c > '9') {
                return -1;
            }
        }
        return Nombre.lire(texte);
    }

    private static double[] deuxEntiers(String texte, char separateur) {
        int k = texte.indexOf(separateur);
        return k < 0 ? new double[] {-1, -1}
                : new double[] {chiffres(texte.substring(0, k)), chiffres(texte.substring(k + 1))};
    }

    private void exiger(boolean juste, String nom) {
        if (!juste) {
            throw impossible(nom, attendue(nom));
        }
    }

    private Echec impossible(String nom, String attendu) {
        return demande("valeur impossible pour " + nom + " : " + Texte.cite(donnees.get(nom)), attendu);
    }

    private static Echec demande(String faute, String attendu) {
        return Echec.demande(faute + " ; attendu : " + attendu);
    }
}
