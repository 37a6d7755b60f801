package lancer.commande;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.contrat.Parametre;
import lancer.systeme.Echec;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/**
 * Une ligne de la table des options : ce qu'elle lit, et ce qu'en disent l'aide, les refus et la fenêtre.
 *
 * @param <T> ce que lit cette option
 */
public final class Option<T> extends Parametre {

    /** Ce qu'est une valeur. */
    private enum Forme { DRAPEAU, FICHIER, MOT, ETAPE, TYPES, ENTIER, NOMBRE, ERREUR, PART, COUPLE }

    /** Place d'un nom et de son exemple dans l'aide, en caractères. */
    private static final int LARGEUR_DES_NOMS = 25;
    private static final int COTE_MAX = 16384;
    private static final int PIXELS_MAX = 100_000_000;
    private static final int FILS_MAX = 1024;

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
            .regle("");
    public static final Option<Etape> ETAPE = mot(Forme.ETAPE, "etape", "une étape du cours",
            "l'image de cette étape : ", Etape.REFLETS, "lambert", "phong", "ombres", "reflets")
            .regle("étape du cours");
    public static final Option<Integer> REFLETS =
            entier("reflets", "5", "nombre de réflexions d'un rayon", Constantes.MAX_REFLETS, 0, 1000)
            .regle("réflexions");
    public static final Option<Double> SEUIL = new Option<>(Forme.NOMBRE, "seuil", "0.0009765625",
            "un nombre positif ou nul, par exemple 0.001", "reflets abandonnés sous ce produit des Ks ; 0 : jamais",
            Constantes.SEUIL).regle("seuil des reflets");
    public static final Option<Set<String>> SANS = new Option<>(Forme.TYPES, "sans", "Brume,Blinn",
            "des noms de variantes séparés par une virgule, par exemple Brume,Blinn",
            "sans ces variantes, même si elles sont dans le chemin des classes", Collections.<String>emptySet())
            .regle("");
    public static final Option<Integer> FILS = entier("fils", "N", "fils d'exécution (sans elle, un par processeur)",
            Math.min(FILS_MAX, Runtime.getRuntime().availableProcessors()), 1, FILS_MAX);
    public static final Option<Integer> REPETER =
            entier("repeter", "N", "dessine N fois avant d'écrire, pour mesurer", 1, 1, 100_000);
    public static final Option<Boolean> STATISTIQUES =
            drapeau("statistiques", "après l'image, rayons et temps, une ligne « nom: valeur » chacun");
    public static final Option<Boolean> SIMPLE =
            drapeau("simple", "les boucles du cours au lieu de la recherche rapide : la même image").regle("");
    public static final Option<Couple> PIXEL = new Option<Couple>(Forme.COUPLE, "pixel", "421,426",
            "X,Y, colonne et ligne d'un pixel depuis le coin en haut à gauche, par exemple 421,426",
            "pourquoi ce pixel a sa couleur : contacts, lampes, reflets, terme par\n"
            + "terme, jusqu'à « somme R V B = #RRGGBB » ; sans fenêtre ni écran", null).entre(0, COTE_MAX).parmi(",")
            .sans(IMAGE, LINEAIRE, REPETER);
    public static final Option<String> VUE = Option.<String>mot(Forme.MOT, "vue", "une vue",
            "avec --image, en fausses couleurs :\n", null, "normales", "distance", "lampes", "rayons", "marge")
            .avec(IMAGE).sans(LINEAIRE, REPETER, PIXEL);
    /** En niveaux ; 0 si les réglages ne sont pas à choisir. */
    public static final Option<Double> AUTO = new Option<>(Forme.ERREUR, "auto", "erreur=1",
            "erreur=E, de 0.01 à 255 niveaux, par exemple erreur=1",
            "choisit reflets, seuil et, s'il est là, anticrénelage : le moins cher\n"
            + "qui tienne cette erreur en niveaux (1/255) ; puis mesure l'image", 0.0).entre(0.01, 255)
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
    public static final Option<Boolean> AIDE = drapeau("aide", "ce texte, comme --help et -h");
    public static final Option<Boolean> VERSION = drapeau("version", "la version");

    /** Le nom, avec ses tirets. */
    public final String nom;
    /** Ce que vaut l'option qui n'est pas donnée. */
    public final T absente;
    /** Une valeur, dans l'aide ; {@code null} si l'option n'en prend pas. */
    private final String exemple;
    private final String aide;
    private final Forme forme;
    private double min;
    private double max = Double.MAX_VALUE;
    /** Le nom du réglage dans la fenêtre, vide si elle ne l'offre pas ; {@code null} si l'image n'en dépend pas. */
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

    private static Option<Boolean> drapeau(String cle, String aide) {
        return new Option<>(Forme.DRAPEAU, cle, null, "aucune valeur", aide, false);
    }

    private static Option<Integer> entier(String cle, String exemple, String aide, int absente, int min, int max) {
        String bornes = min + " à " + max;
        return new Option<>(Forme.ENTIER, cle, exemple, "un entier de " + bornes, aide + ", " + bornes, absente)
                .entre(min, max);
    }

    /** Un de ces mots. @param quoi ce qu'ils sont @param aide ce qui les précède dans l'aide */
    private static <V> Option<V> mot(Forme forme, String cle, String quoi, String aide, V absente, String... mots) {
        String liste = mots[0];
        for (int k = 1; k < mots.length; k++) {
            liste += (k < mots.length - 1 ? ", " : " ou ") + mots[k];
        }
        return new Option<>(forme, cle, mots[0], quoi + " : " + liste, aide + liste, absente).parmi(mots);
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

    /** L'image en dépend. @param nomme son nom dans la fenêtre, ou vide */
    private Option<T> regle(String nomme) {
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

        @Override
        public String toString() {
            return x + "x" + y;
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
        return TABLE.stream().filter(option -> option.titre != null && !option.titre.isEmpty())
                .collect(Collectors.toList());
    }

    @Override
    public String getTitre() {
        return titre;
    }

    boolean prendUneValeur() {
        return exemple != null;
    }

    /** Sa ligne de l'aide. */
    String getAide() {
        String marge = String.format("\n%" + (2 + LARGEUR_DES_NOMS) + "s", "");
        return String.format("  %-" + LARGEUR_DES_NOMS + "s", prendUneValeur() ? nom + " " + exemple : nom)
                + aide.replace("\n", marge) + "\n";
    }

    /** @throws Echec si cette option ne va pas avec une autre, ou ne sert pas sans une autre */
    void accorder(Set<Option<?>> donnees) {
        for (Option<?> autre : separees) {
            if (donnees.contains(autre)) {
                throw Echec.demande(nom + " ne va pas avec " + autre.nom + " ; attendu : l'une ou l'autre");
            }
        }
        if (!servies.isEmpty() && Collections.disjoint(servies, donnees)) {
            throw Echec.demande(nom + " ne sert pas seule ; attendu : avec elle, " + servies.stream()
                    .map(autre -> autre.nom + " " + autre.exemple).collect(Collectors.joining(" ou ")));
        }
    }

    @Override
    public boolean accepte(String texte) {
        return valeur(texte) != null;
    }

    /** La valeur écrite. @throws Echec si elle est impossible */
    @SuppressWarnings("unchecked")
    public T lire(String texte) {
        Object valeur = valeur(texte);
        if (valeur == null) {
            throw impossible(texte, attendu);
        }
        return (T) valeur;
    }

    public Echec impossible(String texte, String voulu) {
        return Echec.demande("valeur impossible pour " + nom + " : " + Texte.cite(texte) + " ; attendu : " + voulu);
    }

    /** La valeur écrite, {@code null} si elle est impossible. */
    private Object valeur(String texte) {
        switch (forme) {
            case DRAPEAU:
                return texte.isEmpty() ? true : null;
            case FICHIER:
                // le nom donné, et non celui du fichier où mène un lien
                int point = Math.max(0, texte.lastIndexOf('.'));
                return valeurs.contains(Texte.minuscules(texte.substring(point))) ? texte : null;
            case MOT:
                return valeurs.contains(texte) ? texte : null;
            case ETAPE:
                return valeurs.contains(texte) ? Etape.values()[valeurs.indexOf(texte)] : null;
            case TYPES:
                Set<String> types = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
                Collections.addAll(types, texte.split(",", -1));
                return types.contains("") ? null : Collections.unmodifiableSet(types);
            case COUPLE:
                String[] deux = texte.split(valeurs.get(0), 2);
                double x = Nombre.lireEntier(deux[0]);
                double y = Nombre.lireEntier(deux[deux.length - 1]);
                boolean permis = deux.length == 2 && Math.min(x, y) >= min && Math.max(x, y) <= max;
                return permis && x * y <= PIXELS_MAX ? new Couple((int) x, (int) y) : null;
            case ENTIER:
                Double entier = borner(Nombre.lireEntier(texte));
                return entier == null ? null : Integer.valueOf(entier.intValue());
            case ERREUR:
                return texte.startsWith("erreur=") ? borner(Nombre.lire(texte.substring("erreur=".length()))) : null;
            case PART:
                boolean pourCent = texte.endsWith("%");
                double n = Nombre.lire(pourCent ? texte.substring(0, texte.length() - 1) : texte);
                // une division arrondirait : 0.7 % doit donner exactement 0.007
                return borner(pourCent && n <= 100 ? BigDecimal.valueOf(n).movePointLeft(2).doubleValue() : n);
            default:
                return borner(Nombre.lire(texte));
        }
    }

    private Double borner(double n) {
        return n >= min && n <= max ? Double.valueOf(n) : null;
    }

    /** L'écriture d'une valeur, que {@link #lire} relit. */
    public String ecrire(T valeur) {
        if (valeur instanceof Set) {
            return ((Set<?>) valeur).stream().map(Object::toString).map(Texte::minuscules)
                    .collect(Collectors.joining(","));
        }
        return valeur instanceof Double ? Nombre.ecrire((Double) valeur) : valeur.toString();
    }
}
