package lancer.commande;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/** La ligne de commande. Une demande fausse est refusée par un {@link Echec}. */
public final class Options {

    public static final List<String> VUES = Collections.unmodifiableList(
            Arrays.asList("normales", "distance", "lampes", "rayons", "marge"));

    /** Une option, puis celles qui ne vont pas avec elle ; une option, puis celles dont une doit aller avec elle. */
    private static final String[][] SEPAREES = {
        {"--pixel", "--image", "--lineaire", "--auto", "--repeter", "--comparer"},
        {"--comparer", "--taille", "--lineaire", "--repeter", "--statistiques", "--auto"},
        {"--vue", "--lineaire", "--auto", "--pixel", "--repeter"}};
    private static final String[][] SERVANTES = {{"--vue", "--image"}, {"--auto", "--image", "--lineaire"},
        {"--tolerance", "--comparer"}, {"--part", "--comparer"}};

    /** Demandes d'un texte seul ; la première l'emporte. */
    public boolean aide;
    public boolean version;

    /** Fichiers à écrire, ou {@code null}. */
    public String image;
    public String lineaire;

    public int largeur = Constantes.LARGEUR_IMAGE;
    public int hauteur = Constantes.HAUTEUR_IMAGE;

    /** La façon de dessiner, avant la lecture de la scène et de ses variantes. */
    public Reglages reglages = new Reglages();

    /** La vue en fausses couleurs à écrire ; {@code null} pour l'image. */
    public String vue;
    public int fils = Math.min(Aide.FILS_MAX, Runtime.getRuntime().availableProcessors());
    public int repeter = 1;
    public boolean statistiques;

    /** Colonne et ligne du seul pixel demandé ; sans lui, −1. */
    public int pixelX = -1;
    public int pixelY = -1;

    /** Erreur voulue, en niveaux, si le programme choisit ses réglages ; 0 sinon. */
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
        if (!options.aide && !options.version) {
            options.lireLesValeurs();
            options.accorder();
        }
        return options;
    }

    public static String getVersion() {
        String version = Options.class.getPackage().getImplementationVersion();
        return "lancer " + (version != null ? version : "(non empaqueté)");
    }

    /** Dit si la demande (fichier, pixel, comparaison) se fait sans fenêtre. */
    public boolean sansFenetre() {
        return image != null || lineaire != null || unPixel() || comparer != null;
    }

    /** Dit si un seul pixel est demandé. */
    public boolean unPixel() {
        return pixelX >= 0;
    }

    /** Dit si le programme choisit ses réglages. */
    public boolean auto() {
        return erreurVoulue > 0;
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
            Aide.Option option = Aide.trouver(nom);
            boolean seule = option.exemple == null;
            if (seule && egal >= 0) {
                throw Echec.demande("option qui ne prend pas de valeur : " + nom + " ; reçu : " + Texte.cite(valeur));
            }
            // dans « --image --fils 2 », le nom du fichier a été oublié
            if (!seule && egal < 0 && k + 1 < arguments.length && !arguments[k + 1].startsWith("--")) {
                valeur = arguments[++k];
            }
            if (donnees.put(nom, valeur) != null) {
                throw demande("option donnée deux fois : " + nom, "une seule fois chaque option");
            }
            if (!seule && valeur.isEmpty()) {
                throw demande("option sans sa valeur : " + nom, option.attendu);
            }
            aide = nom.equals("--aide") || nom.equals("--help") || nom.equals("-h");
            version = nom.equals("--version");
        }
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

    /** Lit les valeurs données ; ce qui n'est pas demandé garde sa valeur. */
    private void lireLesValeurs() {
        image = fichier("--image", ".png");
        lineaire = fichier("--lineaire", ".pfm");
        int[] cotes = deuxEntiers("--taille", "x", Aide.COTE_MAX);
        if (cotes != null) {
            largeur = cotes[0];
            hauteur = cotes[1];
            exiger(largeur >= 1 && hauteur >= 1 && (long) largeur * hauteur <= Aide.PIXELS_MAX, "--taille");
        }
        reglages = reglages.avecReflets(entier("--reflets", 0, Aide.REFLETS_MAX, reglages.getReflets()));
        reglages = reglages.avecSeuil(reel("--seuil", Double.MAX_VALUE, reglages.getSeuil()));
        reglages = reglages.avecEtape(choisie("--etape", Arrays.asList(Etape.values()), reglages.getEtape()));
        if (estDonnee("--sans")) {
            List<String> variantes = Arrays.asList(donnees.get("--sans").split(",", -1));
            exiger(!variantes.contains(""), "--sans");
            reglages = reglages.sans(variantes);
        }
        if (estDonnee("--simple")) {
            reglages = reglages.avecLesBoucles();
        }
        vue = choisie("--vue", VUES, null);
        fils = entier("--fils", 1, Aide.FILS_MAX, fils);
        repeter = entier("--repeter", 1, Aide.REPETER_MAX, repeter);
        statistiques = estDonnee("--statistiques");
        int[] pixel = deuxEntiers("--pixel", ",", Constantes.INFINI);
        if (pixel != null) {
            pixelX = pixel[0];
            pixelY = pixel[1];
        }
        if (estDonnee("--auto")) {
            String souhait = donnees.get("--auto");
            erreurVoulue = souhait.startsWith("erreur=") ? Nombre.lire(souhait.substring("erreur=".length())) : 0;
            exiger(erreurVoulue >= 0.01 && erreurVoulue <= 255, "--auto");
        }
        comparer = fichier("--comparer", ".png", ".pfm");
        tolerance = reel("--tolerance", Double.MAX_VALUE, tolerance);
        if (estDonnee("--part")) {
            lirePart(donnees.get("--part"));
        }
    }

    private void lirePart(String valeur) {
        boolean pourCent = valeur.endsWith("%");
        String nombre = pourCent ? valeur.substring(0, valeur.length() - 1) : valeur;
        part = Nombre.lire(nombre);
        exiger(part >= 0 && part <= (pourCent ? 100 : 1), "--part");
        // pour que 0.7 % donne exactement 0.007 : une division l'arrondirait autrement
        part = pourCent ? new BigDecimal(nombre).movePointLeft(2).doubleValue() : part;
    }

    private void accorder() {
        for (String[] une : SEPAREES) {
            for (int k = 1; k < une.length && estDonnee(une[0]); k++) {
                if (estDonnee(une[k])) {
                    throw demande(une[0] + " ne va pas avec " + une[k], "l'une ou l'autre");
                }
            }
        }
        for (String[] une : SERVANTES) {
            List<String> autres = Arrays.asList(une).subList(1, une.length);
            if (estDonnee(une[0]) && Collections.disjoint(autres, donnees.keySet())) {
                throw demande(une[0] + " ne sert pas seule", "avec elle, " + autres.stream()
                        .map(autre -> autre + " " + Aide.trouver(autre).exemple).collect(Collectors.joining(" ou ")));
            }
        }
        if (sansFenetre() && scene == null) {
            throw demande("aucune scène à dessiner", "un fichier, par exemple scenes/scene1.ini");
        }
        if (comparer != null && vue != null) {
            throw demande("--vue ne va pas avec --comparer", "l'une ou l'autre");
        }
        if (unPixel() && (pixelX >= largeur || pixelY >= hauteur)) {
            throw impossible("--pixel", "un pixel de l'image, de 0,0 à " + (largeur - 1) + "," + (hauteur - 1));
        }
    }

    private <T> T choisie(String nom, List<T> choix, T defaut) {
        for (T une : choix) {
            if (une.toString().equals(donnees.get(nom))) {
                return une;
            }
        }
        exiger(!estDonnee(nom), nom);
        return defaut;
    }

    private String fichier(String nom, String... fins) {
        String fichier = donnees.get(nom);
        boolean juste = fichier == null;
        for (String fin : fins) {
            juste = juste || finit(fichier, fin);
        }
        exiger(juste, nom);
        return fichier;
    }

    /** Deux entiers de 0 à {@code max} ; {@code null} si l'option n'est pas donnée. */
    private int[] deuxEntiers(String nom, String separateur, double max) {
        if (!estDonnee(nom)) {
            return null;
        }
        String[] deux = donnees.get(nom).split(separateur, -1);
        exiger(deux.length == 2, nom);
        return new int[] {entier(deux[0], nom, 0, max), entier(deux[1], nom, 0, max)};
    }

    private int entier(String nom, int min, int max, int defaut) {
        return estDonnee(nom) ? entier(donnees.get(nom), nom, min, max) : defaut;
    }

    private int entier(String valeur, String nom, double min, double max) {
        double n = Nombre.lireEntier(valeur);
        exiger(n >= min && n <= max, nom);
        return (int) n;
    }

    private double reel(String nom, double max, double defaut) {
        double n = estDonnee(nom) ? Nombre.lire(donnees.get(nom)) : defaut;
        exiger(n >= 0 && n <= max, nom);
        return n;
    }

    private void exiger(boolean juste, String nom) {
        if (!juste) {
            throw impossible(nom, Aide.trouver(nom).attendu);
        }
    }

    private Echec impossible(String nom, String attendu) {
        return demande("valeur impossible pour " + nom + " : " + Texte.cite(donnees.get(nom)), attendu);
    }

    private static Echec demande(String faute, String attendu) {
        return Echec.demande(faute + " ; attendu : " + attendu);
    }
}
