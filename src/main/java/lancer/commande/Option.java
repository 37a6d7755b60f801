package lancer.commande;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.StringJoiner;
import java.util.TreeSet;
import lancer.Constantes;
import lancer.contrat.Parametre;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/**
 * Une ligne de la table des options : ce qu'elle lit, et ce qu'en disent l'aide, les refus et la fenêtre. Immuable.
 *
 * @param <T> ce que lit cette option
 */
public abstract class Option<T> extends Parametre {

    /** Place d'un nom et de son exemple dans l'aide, en caractères. */
    private static final int LARGEUR_DES_NOMS = 25;

    private static final int COTE_MAX = 16384;
    private static final int PIXELS_MAX = 100_000_000;
    private static final int FILS_MAX = 1024;

    /** Toutes les options, dans l'ordre de l'aide. */
    static final List<Option<?>> TABLE = new ArrayList<>();

    public static final Option<String> IMAGE = new Fichier("image", "FICHIER.png",
            "un fichier dont le nom finit par .png", "écrit l'image, sans fenêtre ni écran", ".png");
    public static final Option<String> LINEAIRE = new Fichier("lineaire", "FICHIER.pfm",
            "un fichier dont le nom finit par .pfm",
            "écrit les couleurs non limitées (PFM) ; peut aller avec --image", ".pfm");
    public static final Option<Couple> TAILLE = new DeuxEntiers("taille", "800x600", "x",
            "LARGEURxHAUTEUR, par exemple 800x600, de 1 à " + COTE_MAX + " chacune, et au plus " + PIXELS_MAX
            + " pixels", "taille de l'image, 1 à " + COTE_MAX + " pixels de côté",
            new Couple(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE)) {
        @Override
        boolean admet(double x, double y) {
            return x >= 1 && y >= 1 && x <= COTE_MAX && y <= COTE_MAX && x * y <= PIXELS_MAX;
        }
    };
    public static final Option<Etape> ETAPE = new Choix<>("etape", "ombres",
            "une étape du cours : lambert, phong, ombres ou reflets",
            "le cours étape par étape : lambert, phong, ombres, puis reflets", Etape.REFLETS, Etape.values())
            .enFenetre("étape du cours", ", ou les touches F6 à F9");
    public static final Option<Integer> REFLETS = new Entier("reflets", "5", 0, 1000, Constantes.MAX_REFLETS,
            "nombre de réflexions d'un rayon, 0 à 1000").enFenetre("réflexions", ", ou les touches + et −");
    public static final Option<String> VUE = new Choix<>("vue", "normales",
            "une vue : normales, distance, lampes ou rayons",
            "avec --image, en fausses couleurs : normales, distance, lampes\nou rayons", null,
            "normales", "distance", "lampes", "rayons").avec("image")
            .separee("lineaire", "auto", "pixel", "repeter", "comparer");
    public static final Option<Double> SEUIL = new Reel("seuil", "0.0009765625",
            "un nombre positif ou nul, par exemple 0.001", "reflets abandonnés sous ce produit des Ks ; 0 : jamais",
            Constantes.SEUIL).enFenetre("seuil des reflets", "");
    public static final Option<Set<String>> SANS = new Types("sans", "Brume,Blinn",
            "des noms de variantes séparés par une virgule, par exemple Brume,Blinn",
            "sans ces variantes, même si elles sont dans le chemin des classes").reglage();
    public static final Option<Integer> FILS = new Entier("fils", "N", 1, FILS_MAX,
            Math.min(FILS_MAX, Runtime.getRuntime().availableProcessors()),
            "nombre de fils d'exécution, 1 à " + FILS_MAX + " ; sans elle, un par processeur");
    public static final Option<Integer> REPETER = new Entier("repeter", "N", 1, 100_000, 1,
            "dessine N fois avant d'écrire, pour mesurer");
    public static final Option<Boolean> STATISTIQUES = new Drapeau("statistiques",
            "après l'image, rayons et temps, une ligne « nom: valeur » chacun");
    public static final Option<Boolean> SIMPLE = new Drapeau("simple",
            "les boucles du cours au lieu de la recherche rapide : la même image").reglage();
    public static final Option<Couple> PIXEL = new DeuxEntiers("pixel", "421,426", ",",
            "X,Y, colonne et ligne d'un pixel depuis le coin en haut à gauche, par exemple 421,426",
            "pourquoi ce pixel a sa couleur : contacts, lampes, reflets, terme par\n"
            + "terme, jusqu'à « somme R V B = #RRGGBB » ; sans fenêtre ni écran", null)
            .separee("image", "lineaire", "auto", "repeter", "comparer");
    /** En niveaux ; 0 si les réglages ne sont pas à choisir. */
    public static final Option<Double> AUTO = new Reel("auto", "erreur=1",
            "erreur=E, de 0.01 à 255 niveaux, par exemple erreur=1",
            "choisit reflets, seuil et, s'il est là, anticrénelage : le moins cher\n"
            + "qui tienne une erreur quadratique moyenne d'un niveau (1/255) ; puis\n"
            + "contrôle l'image, et dit ce qu'il en est. Avec --image ou --lineaire", 0.0) {
        @Override
        public Double lire(String texte) {
            double erreur = texte.startsWith("erreur=") ? Nombre.lire(texte.substring("erreur=".length())) : 0;
            return erreur >= 0.01 && erreur <= 255 ? erreur : null;
        }
    }.avec("image", "lineaire");
    public static final Option<String> COMPARER = new Fichier("comparer", "REF.png", "une image PNG ou PFM",
            "compare la scène, ou une autre image, à un PNG ou un PFM : statut 0\n"
            + "pareilles, 1 différentes ; --image : l'image des différences", ".png", ".pfm")
            .separee("taille", "lineaire", "repeter", "statistiques", "auto");
    /** En niveaux. */
    public static final Option<Double> TOLERANCE = new Reel("tolerance", "1",
            "un nombre de niveaux positif ou nul, par exemple 1",
            "avec --comparer, l'écart permis, en niveaux sur 255", 0.0).avec("comparer");
    /** De 0 à 1. */
    public static final Option<Double> PART = new Reel("part", "0.5%",
            "une part des pixels, de 0 à 1 ou de 0% à 100%, par exemple 0.5%",
            "avec --comparer, les pixels qui peuvent dépasser cet écart", 0.0) {
        @Override
        public Double lire(String texte) {
            boolean pourCent = texte.endsWith("%");
            String nombre = pourCent ? texte.substring(0, texte.length() - 1) : texte;
            double part = Nombre.lire(nombre);
            if (!(part >= 0 && part <= (pourCent ? 100 : 1))) {
                return null;
            }
            // pour que 0.7 % donne exactement 0.007 : une division l'arrondirait autrement
            return pourCent ? new BigDecimal(nombre).movePointLeft(2).doubleValue() : part;
        }
    }.avec("comparer");
    public static final Option<Boolean> AIDE = new Drapeau("aide", "ce texte, comme --help et -h")
            .aussi("--help", "-h");
    public static final Option<Boolean> VERSION = new Drapeau("version", "la version");

    /** Le nom, avec ses tirets, et ses synonymes. */
    public final String nom;
    private List<String> synonymes = Collections.emptyList();
    /** Un exemple de valeur ; {@code null} si l'option n'en prend pas ; de même ce qui est attendu. */
    final String exemple;
    final String attendu;
    private final String aide;
    /** Ce que vaut l'option qui n'est pas donnée. */
    public final T absente;
    /** Ce que l'option change dans la façon de dessiner, tel que la fenêtre le nomme ; {@code null} si elle ne l'offre pas. */
    private String titre;
    private String touches = "";
    private boolean reglage;
    /** Les options qui ne vont pas avec elle ; celles dont une doit aller avec elle. */
    private List<String> separees = Collections.emptyList();
    private List<String> servies = Collections.emptyList();

    private Option(String cle, String exemple, String attendu, String aide, T absente, Object... possibles) {
        super(cle, null, mots(possibles), null);
        nom = "--" + cle;
        this.exemple = exemple;
        this.attendu = attendu;
        this.aide = aide;
        this.absente = absente;
        TABLE.add(this);
    }

    private static List<String> mots(Object... possibles) {
        List<String> mots = new ArrayList<>();
        for (Object possible : possibles) {
            mots.add(possible.toString());
        }
        return mots;
    }

    /** L'option règle la façon de dessiner, sous ce titre dans la fenêtre. @param touches ce qui l'y change aussi */
    Option<T> enFenetre(String titre, String touches) {
        this.titre = titre;
        this.touches = touches;
        return reglage();
    }

    /** L'option règle la façon de dessiner. */
    Option<T> reglage() {
        reglage = true;
        return this;
    }

    Option<T> aussi(String... autres) {
        synonymes = Arrays.asList(autres);
        return this;
    }

    /** L'option ne sert qu'avec une de celles-ci. */
    Option<T> avec(String... cles) {
        servies = Arrays.asList(cles);
        return this;
    }

    Option<T> separee(String... cles) {
        separees = Arrays.asList(cles);
        return this;
    }

    /** Les options que la fenêtre laisse régler. */
    public static List<Option<?>> enFenetre() {
        List<Option<?>> offertes = new ArrayList<>(TABLE);
        offertes.removeIf(option -> option.titre == null);
        return offertes;
    }

    /** La valeur écrite ; {@code null} si elle est impossible. */
    public abstract T lire(String texte);

    /** L'écriture d'une valeur, que {@link #lire} relit. */
    public String ecrire(T valeur) {
        return valeur.toString();
    }

    @Override
    public boolean accepte(String texte) {
        return lire(texte) != null;
    }

    @Override
    public String getTitre() {
        return titre;
    }

    @Override
    public String getAttendu() {
        return attendu + touches;
    }

    /** Dit si l'option change la façon de dessiner. */
    boolean estUnReglage() {
        return reglage;
    }

    boolean prendUneValeur() {
        return exemple != null;
    }

    boolean seNomme(String mot) {
        return nom.equals(mot) || synonymes.contains(mot);
    }

    /** L'option de ce nom. @throws Echec si elle est inconnue */
    static Option<?> trouver(String mot) {
        for (Option<?> option : TABLE) {
            if (option.seNomme(mot)) {
                return option;
            }
        }
        throw Echec.demande("option inconnue : " + Texte.cite(mot) + " ; attendu : une de celles que montre --aide");
    }

    /** Sa ligne de l'aide. */
    String getAide() {
        String marge = "\n" + String.format("%" + (2 + LARGEUR_DES_NOMS) + "s", "");
        return String.format("  %-" + LARGEUR_DES_NOMS + "s", prendUneValeur() ? nom + " " + exemple : nom)
                + aide.replace("\n", marge) + "\n";
    }

    /** La valeur écrite. @throws Echec si elle est impossible */
    T exiger(String texte) {
        T lue = lire(texte);
        if (lue == null) {
            throw impossible(texte, attendu);
        }
        return lue;
    }

    /** Le refus d'une valeur. */
    public Echec impossible(String texte, String voulu) {
        return Echec.demande("valeur impossible pour " + nom + " : " + Texte.cite(texte) + " ; attendu : " + voulu);
    }

    /** @throws Echec si une des options données ne va pas avec celle-ci */
    void exclure(Set<Option<?>> donnees) {
        for (String cle : separees) {
            if (donnees.contains(trouver("--" + cle))) {
                throw Echec.demande(nom + " ne va pas avec --" + cle + " ; attendu : l'une ou l'autre");
            }
        }
    }

    /** @throws Echec si aucune des options données ne se sert de celle-ci */
    void servir(Set<Option<?>> donnees) {
        StringJoiner voulues = new StringJoiner(" ou ", nom + " ne sert pas seule ; attendu : avec elle, ", "");
        boolean sert = servies.isEmpty();
        for (String cle : servies) {
            Option<?> autre = trouver("--" + cle);
            sert |= donnees.contains(autre);
            voulues.add(autre.nom + " " + autre.exemple);
        }
        if (!sert) {
            throw Echec.demande(voulues.toString());
        }
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

    private static final class Drapeau extends Option<Boolean> {

        Drapeau(String cle, String aide) {
            super(cle, null, null, aide, false);
        }

        @Override
        public Boolean lire(String texte) {
            return true;
        }
    }

    /** Un fichier : c'est le nom donné qui est examiné, et non le fichier où mène un lien. */
    private static final class Fichier extends Option<String> {

        private final String[] fins;

        Fichier(String cle, String exemple, String attendu, String aide, String... fins) {
            super(cle, exemple, attendu, aide, null);
            this.fins = fins;
        }

        @Override
        public String lire(String texte) {
            for (String fin : fins) {
                if (Texte.minuscules(texte).endsWith(fin)) {
                    return texte;
                }
            }
            return null;
        }
    }

    private static final class Entier extends Option<Integer> {

        private final int min;
        private final int max;

        Entier(String cle, String exemple, int min, int max, int absente, String aide) {
            super(cle, exemple, "un entier de " + min + " à " + max, aide.replace("{}", min + " à " + max), absente);
            this.min = min;
            this.max = max;
        }

        @Override
        public Integer lire(String texte) {
            double n = Nombre.lireEntier(texte);
            return n >= min && n <= max ? Integer.valueOf((int) n) : null;
        }
    }

    /** Un nombre positif ou nul. */
    private static class Reel extends Option<Double> {

        Reel(String cle, String exemple, String attendu, String aide, double absente) {
            super(cle, exemple, attendu, aide, absente);
        }

        @Override
        public Double lire(String texte) {
            double n = Nombre.lire(texte);
            return n >= 0 && n < Constantes.INFINI ? Double.valueOf(n) : null;
        }

        @Override
        public String ecrire(Double valeur) {
            return Nombre.ecrire(valeur);
        }
    }

    private static class DeuxEntiers extends Option<Couple> {

        private final String separateur;

        DeuxEntiers(String cle, String exemple, String separateur, String attendu, String aide, Couple absente) {
            super(cle, exemple, attendu, aide, absente);
            this.separateur = separateur;
        }

        @Override
        public Couple lire(String texte) {
            String[] deux = texte.split(separateur, -1);
            if (deux.length != 2) {
                return null;
            }
            double x = Nombre.lireEntier(deux[0]);
            double y = Nombre.lireEntier(deux[1]);
            return admet(x, y) ? new Couple((int) x, (int) y) : null;
        }

        boolean admet(double x, double y) {
            return x >= 0 && y >= 0;
        }

        @Override
        public String ecrire(Couple valeur) {
            return valeur.x + separateur + valeur.y;
        }
    }

    /** Un mot parmi ceux qui écrivent ces valeurs. */
    private static final class Choix<T> extends Option<T> {

        private final List<T> possibles;

        @SafeVarargs
        Choix(String cle, String exemple, String attendu, String aide, T absente, T... possibles) {
            super(cle, exemple, attendu, aide, absente, possibles);
            this.possibles = Arrays.asList(possibles);
        }

        @Override
        public T lire(String texte) {
            int rang = valeurs.indexOf(texte);
            return rang < 0 ? null : possibles.get(rang);
        }
    }

    /** Des types de variantes, quelle que soit leur casse. */
    private static final class Types extends Option<Set<String>> {

        Types(String cle, String exemple, String attendu, String aide) {
            super(cle, exemple, attendu, aide, Collections.emptySet());
        }

        @Override
        public Set<String> lire(String texte) {
            Set<String> types = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
            Collections.addAll(types, texte.split(",", -1));
            return types.contains("") ? null : Collections.unmodifiableSet(types);
        }

        @Override
        public String ecrire(Set<String> types) {
            return String.join(",", types);
        }
    }
}
