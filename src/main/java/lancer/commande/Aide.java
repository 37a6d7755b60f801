package lancer.commande;

import lancer.texte.Texte;

/** Les options de la ligne de commande, et leur aide. */
public final class Aide {

    /** Place d'un nom et de son exemple dans l'aide, en caractères. */
    private static final int LARGEUR_DES_NOMS = 25;

    public static final int REFLETS_MAX = 1000;
    static final int COTE_MAX = 16384;
    static final int PIXELS_MAX = 100_000_000;
    static final int FILS_MAX = 1024;
    static final int REPETER_MAX = 100_000;

    /** Les options, dans l'ordre de l'aide : nom, exemple de sa valeur, valeur attendue et aide. */
    private static final Option[] TABLE = {
        new Option("--image", "FICHIER.png", "un fichier dont le nom finit par .png",
                "écrit l'image, sans fenêtre ni écran"),
        new Option("--lineaire", "FICHIER.pfm", "un fichier dont le nom finit par .pfm",
                "écrit les couleurs non limitées (PFM) ; peut aller avec --image"),
        new Option("--taille", "800x600", "LARGEURxHAUTEUR, par exemple 800x600, de 1 à " + COTE_MAX
                + " chacune, et au plus " + PIXELS_MAX + " pixels",
                "taille de l'image, 1 à " + COTE_MAX + " pixels de côté"),
        new Option("--reflets", "5", "un entier de 0 à " + REFLETS_MAX,
                "nombre de réflexions d'un rayon, 0 à " + REFLETS_MAX),
        new Option("--etape", "ombres", "une étape du cours : lambert, phong, ombres ou reflets",
                "le cours étape par étape : lambert, phong, ombres, puis reflets"),
        new Option("--vue", "normales", "une vue : normales, distance, lampes, rayons ou marge",
                "avec --image, en fausses couleurs : normales, distance, lampes,\n"
                + "rayons ou marge, les décimales qu'un rayon peut perdre"),
        new Option("--seuil", "0.0009765625", "un nombre positif ou nul, par exemple 0.001",
                "reflets abandonnés sous ce produit des Ks ; 0 : jamais"),
        new Option("--sans", "Brume,Blinn", "des noms de variantes séparés par une virgule, par exemple Brume,Blinn",
                "sans ces variantes, même si elles sont dans le chemin des classes"),
        new Option("--fils", "N", "un entier de 1 à " + FILS_MAX,
                "nombre de fils d'exécution, 1 à " + FILS_MAX + " ; sans elle, un par processeur"),
        new Option("--repeter", "N", "un entier de 1 à " + REPETER_MAX,
                "dessine N fois avant d'écrire, pour mesurer"),
        new Option("--statistiques", null, null, "après l'image, rayons et temps, une ligne « nom: valeur » chacun"),
        new Option("--simple", null, null, "les boucles du cours au lieu de la recherche rapide : la même image"),
        new Option("--pixel", "421,426",
                "X,Y, colonne et ligne d'un pixel depuis le coin en haut à gauche, par exemple 421,426",
                "pourquoi ce pixel a sa couleur : contacts, lampes, reflets, terme par\n"
                + "terme, jusqu'à « somme R V B = #RRGGBB » ; sans fenêtre ni écran"),
        new Option("--auto", "erreur=1", "erreur=E, de 0.01 à 255 niveaux, par exemple erreur=1",
                "choisit reflets, seuil et, s'il est là, anticrénelage : le moins cher\n"
                + "qui tienne une erreur quadratique moyenne d'un niveau (1/255) ; puis\n"
                + "contrôle l'image, et dit ce qu'il en est. Avec --image ou --lineaire"),
        new Option("--comparer", "REF.png", "une image PNG ou PFM",
                "compare la scène, ou une autre image, à un PNG ou un PFM : statut 0\n"
                + "pareilles, 1 différentes ; --image : l'image des différences"),
        new Option("--tolerance", "1", "un nombre de niveaux positif ou nul, par exemple 1",
                "avec --comparer, l'écart permis, en niveaux sur 255"),
        new Option("--part", "0.5%", "une part des pixels, de 0 à 1 ou de 0% à 100%, par exemple 0.5%",
                "avec --comparer, les pixels qui peuvent dépasser cet écart"),
        new Option("--aide", null, null, "ce texte, comme --help et -h"),
        new Option("--help", null, null, null),
        new Option("-h", null, null, null),
        new Option("--version", null, null, "la version")};

    private Aide() {
    }

    /** Une option : son nom, et ce que l'aide en dit. */
    static final class Option {

        final String nom;
        /** {@code null} si l'option ne prend pas de valeur ; de même ce qui est attendu. */
        final String exemple;
        final String attendu;
        /** {@code null} si l'aide n'a pas de ligne de cette option. */
        final String aide;

        Option(String nom, String exemple, String attendu, String aide) {
            this.nom = nom;
            this.exemple = exemple;
            this.attendu = attendu;
            this.aide = aide;
        }

        String getLigne() {
            String marge = "\n" + String.format("%" + (2 + LARGEUR_DES_NOMS) + "s", "");
            return String.format("  %-" + LARGEUR_DES_NOMS + "s", exemple == null ? nom : nom + " " + exemple)
                    + aide.replace("\n", marge) + "\n";
        }
    }

    public static String getTexte() {
        StringBuilder aide = new StringBuilder("Usage : java -jar target/lancer.jar [options] scenes/scene1.ini\n\n"
                + "Dessine une scène par lancer de rayons : dans une fenêtre, ou dans un fichier.\n\n");
        for (Option option : TABLE) {
            aide.append(option.aide == null ? "" : option.getLigne());
        }
        return aide + "\nUne option s'écrit aussi --option=valeur, et l'ordre n'a pas d'importance.\n"
                + "Statut de sortie : 0 fait, 1 la machine n'a pas pu, 2 demande fausse.";
    }

    /** L'option de ce nom. @throws Echec si elle est inconnue */
    static Option trouver(String nom) {
        for (Option option : TABLE) {
            if (option.nom.equals(nom)) {
                return option;
            }
        }
        throw Echec.demande("option inconnue : " + Texte.cite(nom) + " ; attendu : une de celles que montre --aide");
    }
}
