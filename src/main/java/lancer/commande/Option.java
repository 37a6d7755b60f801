package lancer.commande;

import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.contrat.Parametre;
import lancer.systeme.Echec;
import lancer.texte.Texte;

/**
 * Une ligne de la table des options : comment sa valeur se lit, et ce qu'en disent l'aide, les refus et la fenêtre.
 *
 * @param <T> ce que lit cette option
 */
public final class Option<T> {

    /** Place d'un nom et de son exemple dans l'aide, en caractères. */
    private static final int LARGEUR_DES_NOMS = 25;
    private static final int COTE_MAX = 16384;
    private static final int PIXELS_MAX = 100_000_000;
    private static final int FILS_MAX = 1024;

    /** Les vues en fausses couleurs. */
    public static final List<String> VUES =
            Collections.unmodifiableList(Arrays.asList("normales", "distance", "lampes", "rayons", "marge"));

    public static final Option<String> IMAGE = new Option<>("image", "FICHIER.png", Lecture.fichier(".png"),
            "un fichier dont le nom finit par .png", "écrit l'image, sans fenêtre ni écran", null);
    public static final Option<String> LINEAIRE = new Option<>("lineaire", "FICHIER.pfm", Lecture.fichier(".pfm"),
            "un fichier dont le nom finit par .pfm",
            "écrit les couleurs non limitées (PFM) ; peut aller avec --image", null);
    public static final Option<Couple> TAILLE = new Option<>("taille", "800x600",
            Lecture.couple("x", 1, COTE_MAX, PIXELS_MAX),
            "LARGEURxHAUTEUR, par exemple 800x600, de 1 à " + COTE_MAX + " chacune, et au plus " + PIXELS_MAX
            + " pixels", "taille de l'image, 1 à " + COTE_MAX + " pixels de côté",
            new Couple(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE)).pourLImage();
    public static final Option<Etape> ETAPE = parmi("etape", Arrays.asList(Etape.values()), "une étape du cours",
            "l'image de cette étape : ", Etape.REFLETS).pourLImage().enFenetre("étape du cours", Etape.values());
    public static final Option<Integer> REFLETS =
            entier("reflets", "5", "nombre de réflexions d'un rayon", Constantes.MAX_REFLETS, 0, 1000)
            .pourLImage().enFenetre("réflexions");
    public static final Option<Double> SEUIL = new Option<>("seuil", "0.0009765625",
            Lecture.nombre("", 0, Double.MAX_VALUE), "un nombre positif ou nul, par exemple 0.001",
            "reflets abandonnés sous ce produit des Ks ; 0 : jamais", Constantes.SEUIL)
            .pourLImage().enFenetre("seuil des reflets");
    public static final Option<Set<String>> SANS = new Option<>("sans", "Brume,Blinn", Lecture.noms(),
            "des noms de variantes séparés par une virgule, par exemple Brume,Blinn",
            "sans ces variantes, même si elles sont dans le chemin des classes", Collections.<String>emptySet())
            .pourLImage();
    public static final Option<Integer> FILS = entier("fils", "N", "fils d'exécution (sans elle, un par processeur)",
            Math.min(FILS_MAX, Runtime.getRuntime().availableProcessors()), 1, FILS_MAX);
    public static final Option<Integer> REPETER =
            entier("repeter", "N", "dessine N fois avant d'écrire, pour mesurer", 1, 1, 100_000);
    public static final Option<Boolean> STATISTIQUES =
            presence("statistiques", "après l'image, rayons et temps, une ligne « nom: valeur » chacun");
    public static final Option<Boolean> SIMPLE =
            presence("simple", "les boucles du cours au lieu de la recherche rapide : la même image").pourLImage();
    public static final Option<Couple> PIXEL = new Option<>("pixel", "421,426",
            Lecture.couple(",", 0, COTE_MAX, PIXELS_MAX),
            "X,Y, colonne et ligne d'un pixel depuis le coin en haut à gauche, par exemple 421,426",
            "pourquoi ce pixel a sa couleur : contacts, lampes, reflets, terme par\n"
            + "terme, jusqu'à « somme R V B = #RRGGBB » ; sans fenêtre ni écran", (Couple) null)
            .sans(IMAGE, LINEAIRE, REPETER);
    public static final Option<String> VUE = parmi("vue", VUES, "une vue", "avec --image, en fausses couleurs :\n",
            null).avecUne(IMAGE).sans(LINEAIRE, REPETER, PIXEL);
    /** En niveaux ; 0 si les réglages ne sont pas à choisir. */
    public static final Option<Double> AUTO = new Option<>("auto", "erreur=1", Lecture.nombre("erreur=", 0.01, 255),
            "erreur=E, de 0.01 à 255 niveaux, par exemple erreur=1",
            "choisit reflets, seuil et, s'il est là, anticrénelage : le moins cher\n"
            + "qui tienne cette erreur en niveaux (1/255) ; puis mesure l'image", 0.0)
            .avecUne(IMAGE, LINEAIRE).sans(PIXEL, VUE);
    public static final Option<String> COMPARER = new Option<>("comparer", "REF.png", Lecture.fichier(".png", ".pfm"),
            "une image PNG ou PFM", "compare la scène, ou une autre image, à un PNG ou un PFM : statut 0\n"
            + "pareilles, 1 différentes ; --image : l'image des différences", (String) null)
            .sans(TAILLE, LINEAIRE, VUE, REPETER, STATISTIQUES, PIXEL, AUTO);
    /** En niveaux. */
    public static final Option<Double> TOLERANCE = new Option<>("tolerance", "1",
            Lecture.nombre("", 0, Double.MAX_VALUE), "un nombre de niveaux positif ou nul, par exemple 1",
            "avec --comparer, l'écart permis, en niveaux sur 255", 0.0).avecUne(COMPARER);
    /** De 0 à 1. */
    public static final Option<Double> PART = new Option<>("part", "0.5%", Lecture.part(),
            "une part des pixels, de 0 à 1 ou de 0% à 100%, par exemple 0.5%",
            "avec --comparer, les pixels qui peuvent dépasser cet écart", 0.0).avecUne(COMPARER);
    public static final Option<Boolean> AIDE = presence("aide", "ce texte, comme --help et -h");
    public static final Option<Boolean> VERSION = presence("version", "la version");

    /** Toutes les options, dans l'ordre de l'aide. */
    static final List<Option<?>> TABLE = Collections.unmodifiableList(Arrays.asList(IMAGE, LINEAIRE, TAILLE, ETAPE,
            REFLETS, SEUIL, SANS, FILS, REPETER, STATISTIQUES, SIMPLE, PIXEL, VUE, AUTO, COMPARER, TOLERANCE, PART,
            AIDE, VERSION));

    /** Le nom, avec ses tirets. */
    public final String nom;
    /** Ce que vaut l'option qui n'est pas donnée. */
    public final T absente;
    /** Une valeur, dans l'aide ; {@code null} si l'option n'en prend pas. */
    private final String exemple;
    private final Lecture<T> lecture;
    /** Ce qu'est une valeur, dans un refus. */
    final String attendu;
    private final String aide;
    /** Vrai si deux de ses valeurs peuvent donner deux images d'une même scène. */
    boolean changeLImage;
    /** Son nom dans la fenêtre, {@code null} si elle ne la laisse pas régler ; et ses mots à choisir. */
    private String titre;
    private Object[] mots;
    /** Les options dont une doit aller avec elle ; celles qui ne vont pas avec elle. */
    private List<Option<?>> requises = Collections.emptyList();
    private List<Option<?>> incompatibles = Collections.emptyList();

    private Option(String cle, String exemple, Lecture<T> lecture, String attendu, String aide, T absente) {
        nom = "--" + cle;
        this.exemple = exemple;
        this.lecture = lecture;
        this.attendu = attendu;
        this.aide = aide;
        this.absente = absente;
    }

    private static Option<Boolean> presence(String cle, String aide) {
        return new Option<>(cle, null, Lecture.presence(), "aucune valeur", aide, false);
    }

    private static Option<Integer> entier(String cle, String exemple, String aide, int absente, int min, int max) {
        String bornes = min + " à " + max;
        return new Option<>(cle, exemple, Lecture.entier(min, max), "un entier de " + bornes, aide + ", " + bornes,
                absente);
    }

    /** Une de ces valeurs. @param quoi ce qu'elles sont @param aide ce qui les précède dans l'aide */
    private static <V> Option<V> parmi(String cle, List<V> valeurs, String quoi, String aide, V absente) {
        String liste = valeurs.get(0).toString();
        for (int k = 1; k < valeurs.size(); k++) {
            liste += (k < valeurs.size() - 1 ? ", " : " ou ") + valeurs.get(k);
        }
        return new Option<>(cle, valeurs.get(0).toString(), Lecture.parmi(valeurs), quoi + " : " + liste, aide + liste,
                absente);
    }

    private Option<T> pourLImage() {
        changeLImage = true;
        return this;
    }

    /** La fenêtre la laisse régler, sous ce nom. @param choix les mots à choisir ; aucun pour un texte à taper */
    private Option<T> enFenetre(String nomDuReglage, Object... choix) {
        titre = nomDuReglage;
        mots = choix;
        return this;
    }

    private Option<T> avecUne(Option<?>... options) {
        requises = Arrays.asList(options);
        return this;
    }

    private Option<T> sans(Option<?>... options) {
        incompatibles = Arrays.asList(options);
        return this;
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
        return TABLE.stream().filter(option -> option.titre != null).collect(Collectors.toList());
    }

    /** Ce que montre la fenêtre d'une option qu'elle laisse régler. */
    public Parametre getParametre() {
        return Parametre.texte(titre, attendu, this::accepte, mots);
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
    void accorder(Collection<Option<?>> donnees) {
        for (Option<?> incompatible : incompatibles) {
            if (donnees.contains(incompatible)) {
                throw Echec.demande(nom + " ne va pas avec " + incompatible.nom + " ; attendu : l'une ou l'autre");
            }
        }
        if (!requises.isEmpty() && Collections.disjoint(requises, donnees)) {
            throw Echec.demande(nom + " ne sert pas seule ; attendu : avec elle, " + requises.stream()
                    .map(requise -> requise.nom + " " + requise.exemple).collect(Collectors.joining(" ou ")));
        }
    }

    public boolean accepte(String texte) {
        return lecture.lire(texte) != null;
    }

    /** La valeur écrite. @throws Echec si elle est impossible */
    public T lire(String texte) {
        T valeur = lecture.lire(texte);
        if (valeur == null) {
            throw impossible(texte, attendu);
        }
        return valeur;
    }

    /** L'écriture d'une valeur, que {@link #lire} relit. */
    public String ecrire(T valeur) {
        return lecture.ecrire(valeur);
    }

    /** @param voulu ce qui était attendu à la place de ce texte */
    public Echec impossible(String texte, String voulu) {
        return Echec.demande("valeur impossible pour " + nom + " : " + Texte.cite(texte) + " ; attendu : " + voulu);
    }
}
