package lancer.commande;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import lancer.Constantes;
import lancer.contrat.Parametre;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/**
 * Une ligne de la table des options : ce qu'elle lit, et ce qu'en disent l'aide, les refus et la fenêtre.
 *
 * @param <T> ce que lit cette option
 */
public final class Option<T> extends Parametre {

    /** Ce qu'est une valeur. */
    private enum Forme { DRAPEAU, FICHIER, VUE, ETAPE, TYPES, ENTIER, NOMBRE, ERREUR, PART, COUPLE }

    /** Place d'un nom et de son exemple dans l'aide, en caractères. */
    private static final int LARGEUR_DES_NOMS = 25;
    static final int COTE_MAX = 16384;
    static final int PIXELS_MAX = 100_000_000;
    private static final int FILS_MAX = 1024;
    /** Longueur de la fin d'un nom de fichier, par exemple « .png ». */
    private static final int FIN = 4;

    /** Toutes les options, dans l'ordre de l'aide. */
    static final List<Option<?>> TABLE = new ArrayList<>();

    public static final Option<String> IMAGE = new Option<String>(Forme.FICHIER, "image", "FICHIER.png",
            "un fichier dont le nom finit par .png", "écrit l'image, sans fenêtre ni écran", null).parmi(".png");
    public static final Option<String> LINEAIRE = new Option<String>(Forme.FICHIER, "lineaire", "FICHIER.pfm",
            "un fichier dont le nom finit par .pfm",
            "écrit les couleurs non limitées (PFM) ; peut aller avec --image", null).parmi(".pfm");
    public static final Option<Couple> TAILLE = new Option<>(Forme.COUPLE, "taille", "800x600",
            "LARGEURxHAUTEUR, par exemple 800x600, de 1 à " + COTE_MAX + " chacune, et au plus " + PIXELS_MAX
            + " pixels", "taille de l'image, 1 à " + COTE_MAX + " pixels de côté",
            new Couple(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE)).entre(1, COTE_MAX).parmi("x")
            .regle(null);
    public static final Option<Etape> ETAPE = new Option<>(Forme.ETAPE, "etape", "ombres",
            "une étape du cours : lambert, phong, ombres ou reflets",
            "le cours étape par étape : lambert, phong, ombres, puis reflets", Etape.REFLETS)
            .parmi("lambert", "phong", "ombres", "reflets").regle("étape du cours");
    public static final Option<Integer> REFLETS = new Option<>(Forme.ENTIER, "reflets", "5", "un entier de 0 à 1000",
            "nombre de réflexions d'un rayon, 0 à 1000", Constantes.MAX_REFLETS).entre(0, 1000).regle("réflexions");
    public static final Option<String> VUE = new Option<String>(Forme.VUE, "vue", "normales",
            "une vue : normales, distance, lampes, rayons ou marge",
            "avec --image, en fausses couleurs : normales, distance, lampes,\nrayons ou marge", null)
            .parmi("normales", "distance", "lampes", "rayons", "marge").avec(IMAGE).sans(LINEAIRE);
    public static final Option<Double> SEUIL = new Option<>(Forme.NOMBRE, "seuil", "0.0009765625",
            "un nombre positif ou nul, par exemple 0.001", "reflets abandonnés sous ce produit des Ks ; 0 : jamais",
            Constantes.SEUIL).regle("seuil des reflets");
    public static final Option<Set<String>> SANS = new Option<>(Forme.TYPES, "sans", "Brume,Blinn",
            "des noms de variantes séparés par une virgule, par exemple Brume,Blinn",
            "sans ces variantes, même si elles sont dans le chemin des classes", Collections.<String>emptySet())
            .regle(null);
    public static final Option<Integer> FILS = new Option<>(Forme.ENTIER, "fils", "N",
            "un entier de 1 à " + FILS_MAX,
            "nombre de fils d'exécution, 1 à " + FILS_MAX + " ; sans elle, un par processeur",
            Math.min(FILS_MAX, Runtime.getRuntime().availableProcessors())).entre(1, FILS_MAX);
    public static final Option<Integer> REPETER = new Option<>(Forme.ENTIER, "repeter", "N",
            "un entier de 1 à 100000", "dessine N fois avant d'écrire, pour mesurer", 1).entre(1, 100_000).sans(VUE);
    public static final Option<Boolean> STATISTIQUES = new Option<>(Forme.DRAPEAU, "statistiques", null, null,
            "après l'image, rayons et temps, une ligne « nom: valeur » chacun", false);
    public static final Option<Boolean> SIMPLE = new Option<>(Forme.DRAPEAU, "simple", null, null,
            "les boucles du cours au lieu de la recherche rapide : la même image", false).regle(null);
    public static final Option<Couple> PIXEL = new Option<Couple>(Forme.COUPLE, "pixel", "421,426",
            "X,Y, colonne et ligne d'un pixel depuis le coin en haut à gauche, par exemple 421,426",
            "pourquoi ce pixel a sa couleur : contacts, lampes, reflets, terme par\n"
            + "terme, jusqu'à « somme R V B = #RRGGBB » ; sans fenêtre ni écran", null).parmi(",")
            .sans(IMAGE, LINEAIRE, VUE, REPETER);
    /** En niveaux ; 0 si les réglages ne sont pas à choisir. */
    public static final Option<Double> AUTO = new Option<>(Forme.ERREUR, "auto", "erreur=1",
            "erreur=E, de 0.01 à 255 niveaux, par exemple erreur=1",
            "choisit reflets, seuil et, s'il est là, anticrénelage : le moins cher\n"
            + "qui tienne une erreur quadratique moyenne d'un niveau (1/255) ; puis\n"
            + "contrôle l'image, et dit ce qu'il en est. Avec --image ou --lineaire", 0.0).entre(0.01, 255)
            .avec(IMAGE, LINEAIRE).sans(PIXEL, VUE);
    public static final Option<String> COMPARER = new Option<String>(Forme.FICHIER, "comparer", "REF.png",
            "une image PNG ou PFM", "compare la scène, ou une autre image, à un PNG ou un PFM : statut 0\n"
            + "pareilles, 1 différentes ; --image : l'image des différences", null).parmi(".png", ".pfm")
            .sans(TAILLE, LINEAIRE, VUE, REPETER, STATISTIQUES, PIXEL, AUTO);
    /** En niveaux. */
    public static final Option<Double> TOLERANCE = new Option<>(Forme.NOMBRE, "tolerance", "1",
            "un nombre de niveaux positif ou nul, par exemple 1",
            "avec --comparer, l'écart permis, en niveaux sur 255", 0.0).avec(COMPARER);
    /** De 0 à 1. */
    public static final Option<Double> PART = new Option<>(Forme.PART, "part", "0.5%",
            "une part des pixels, de 0 à 1 ou de 0% à 100%, par exemple 0.5%",
            "avec --comparer, les pixels qui peuvent dépasser cet écart", 0.0).entre(0, 1).avec(COMPARER);
    public static final Option<Boolean> AIDE = new Option<>(Forme.DRAPEAU, "aide", null, null,
            "ce texte, comme --help et -h", false);
    public static final Option<Boolean> VERSION = new Option<>(Forme.DRAPEAU, "version", null, null, "la version",
            false);

    /** Le nom, avec ses tirets. */
    public final String nom;
    /** Ce que vaut l'option qui n'est pas donnée. */
    public final T absente;
    final String exemple;
    private final Forme forme;
    private final String aide;
    private double min;
    private double max = Double.MAX_VALUE;
    private boolean reglage;
    /** Le nom du réglage dans la fenêtre ; {@code null} si elle ne l'offre pas. */
    private String titre;
    /** Les options dont une doit aller avec elle ; celles qui ne vont pas avec elle. */
    private List<Option<?>> servies = Collections.emptyList();
    private List<Option<?>> separees = Collections.emptyList();

    private Option(Forme forme, String cle, String exemple, String attendu, String aide, T absente) {
        super(cle, null, new ArrayList<>(), null, attendu);
        nom = "--" + cle;
        this.forme = forme;
        this.exemple = exemple;
        this.aide = aide;
        this.absente = absente;
        TABLE.add(this);
    }

    private Option<T> entre(double plusPetit, double plusGrand) {
        min = plusPetit;
        max = plusGrand;
        return this;
    }

    /** Les mots possibles, les fins d'un nom de fichier, ou ce qui sépare deux entiers. */
    private Option<T> parmi(String... mots) {
        Collections.addAll(valeurs, mots);
        return this;
    }

    /** L'option change l'image. @param nomme son nom dans la fenêtre, ou {@code null} */
    private Option<T> regle(String nomme) {
        reglage = true;
        titre = nomme;
        return this;
    }

    private Option<T> avec(Option<?>... une) {
        servies = Arrays.asList(une);
        return this;
    }

    private Option<T> sans(Option<?>... aucune) {
        separees = Arrays.asList(aucune);
        return this;
    }

    /** Deux entiers : la largeur et la hauteur d'une image, ou la colonne et la ligne d'un pixel. Immuable. */
    public static final class Couple {

        public final int x;
        public final int y;

        public Couple(int x, int y) {
            this.x = x;
            this.y = y;
        }
    }

    /** L'option de ce nom. @throws Echec si elle est inconnue */
    static Option<?> trouver(String mot) {
        String cherche = mot.equals("--help") || mot.equals("-h") ? AIDE.nom : mot;
        for (Option<?> option : TABLE) {
            if (option.nom.equals(cherche)) {
                return option;
            }
        }
        throw Echec.demande("option inconnue : " + Texte.cite(mot) + " ; attendu : une de celles que montre --aide");
    }

    /** Les options que la fenêtre laisse régler. */
    public static List<Option<?>> enFenetre() {
        List<Option<?>> offertes = new ArrayList<>(TABLE);
        offertes.removeIf(option -> option.titre == null);
        return offertes;
    }

    @Override
    public String getTitre() {
        return titre;
    }

    boolean estUnReglage() {
        return reglage;
    }

    boolean prendUneValeur() {
        return forme != Forme.DRAPEAU;
    }

    /** Sa ligne de l'aide. */
    String getAide() {
        String marge = "\n" + String.format("%" + (2 + LARGEUR_DES_NOMS) + "s", "");
        return String.format("  %-" + LARGEUR_DES_NOMS + "s", prendUneValeur() ? nom + " " + exemple : nom)
                + aide.replace("\n", marge) + "\n";
    }

    /** @throws Echec si cette option ne va pas avec une autre */
    void exclure(Set<Option<?>> donnees) {
        for (Option<?> autre : separees) {
            if (donnees.contains(autre)) {
                throw Echec.demande(nom + " ne va pas avec " + autre.nom + " ; attendu : l'une ou l'autre");
            }
        }
    }

    /** @throws Echec si cette option ne sert pas sans une autre */
    void servir(Set<Option<?>> donnees) {
        if (!servies.isEmpty() && Collections.disjoint(servies, donnees)) {
            List<String> voulues = new ArrayList<>();
            servies.forEach(autre -> voulues.add(autre.nom + " " + autre.exemple));
            throw Echec.demande(nom + " ne sert pas seule ; attendu : avec elle, " + String.join(" ou ", voulues));
        }
    }

    @Override
    public boolean accepte(String texte) {
        return valeur(texte) != null;
    }

    /** La valeur écrite. @throws Echec si elle est impossible */
    @SuppressWarnings("unchecked")
    public T lire(String texte) {
        if (!accepte(texte)) {
            throw impossible(texte, attendu);
        }
        return (T) valeur(texte);
    }

    public Echec impossible(String texte, String voulu) {
        return Echec.demande("valeur impossible pour " + nom + " : " + Texte.cite(texte) + " ; attendu : " + voulu);
    }

    /** La valeur écrite, {@code null} si elle est impossible. */
    private Object valeur(String texte) {
        switch (forme) {
            case DRAPEAU:
                return true;
            case FICHIER:
                // le nom donné, et non celui du fichier où mène un lien
                return texte.length() >= FIN
                        && valeurs.contains(Texte.minuscules(texte.substring(texte.length() - FIN)))
                        ? texte : null;
            case VUE:
                return valeurs.contains(texte) ? texte : null;
            case ETAPE:
                return valeurs.contains(texte) ? Etape.valueOf(texte.toUpperCase(Locale.ROOT)) : null;
            case TYPES:
                Set<String> types = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
                Collections.addAll(types, texte.split(",", -1));
                return types.contains("") ? null : Collections.unmodifiableSet(types);
            case COUPLE:
                String[] deux = texte.split(valeurs.get(0), -1);
                double x = deux.length == 2 ? Nombre.lireEntier(deux[0]) : -1;
                double y = deux.length == 2 ? Nombre.lireEntier(deux[1]) : -1;
                return borner(x) != null && borner(y) != null ? new Couple((int) x, (int) y) : null;
            case ENTIER:
                Double entier = borner(Nombre.lireEntier(texte));
                return entier == null ? null : Integer.valueOf(entier.intValue());
            case ERREUR:
                return texte.startsWith("erreur=") ? borner(Nombre.lire(texte.substring("erreur=".length()))) : null;
            case PART:
                // une division arrondirait : 0.7 % doit donner exactement 0.007
                boolean pourCent = texte.endsWith("%");
                double n = Nombre.lire(pourCent ? texte.substring(0, texte.length() - 1) : texte);
                return borner(pourCent && Double.isFinite(n) ? BigDecimal.valueOf(n).movePointLeft(2).doubleValue()
                        : n);
            default:
                return borner(Nombre.lire(texte));
        }
    }

    private Double borner(double n) {
        return n >= min && n <= max ? Double.valueOf(n) : null;
    }

    /** L'écriture d'une valeur, que {@link #lire} relit. */
    @SuppressWarnings("unchecked")
    public String ecrire(T valeur) {
        if (forme == Forme.TYPES) {
            return Texte.minuscules(String.join(",", (Set<String>) valeur));
        }
        if (forme == Forme.COUPLE) {
            return ((Couple) valeur).x + valeurs.get(0) + ((Couple) valeur).y;
        }
        return valeur instanceof Double ? Nombre.ecrire((Double) valeur) : valeur.toString();
    }
}
