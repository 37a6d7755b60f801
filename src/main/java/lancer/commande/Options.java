package lancer.commande;

import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import lancer.Constantes;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/** La ligne de commande, lue de gauche à droite : ce qui est demandé, ou un {@link Echec} qui dit pourquoi non. */
public final class Options {

    /** Plus grand côté d'une image, en pixels. */
    public static final int COTE_MAX = 16384;

    /** Plus grand nombre de pixels d'une image. */
    public static final int PIXELS_MAX = 100_000_000;

    private static final int REFLETS_MAX = 1000;
    private static final int FILS_MAX = 1024;
    private static final int REPETER_MAX = 100_000;
    private static final double ERREUR_MIN = 0.01;
    private static final double ERREUR_MAX = 255;
    private static final double TEMPS_MIN = 0.001;
    private static final double TEMPS_MAX = 3600;
    private static final String AUTO =
            "erreur=E, de 0.01 à 255 niveaux, ou temps=T, de 1ms à 3600s, par exemple erreur=1 ou temps=0.5s";

    private static final String PIXEL =
            "X,Y, colonne et ligne d'un pixel depuis le coin en haut à gauche, par exemple 421,426";

    /** Ce que l'image d'un seul pixel ne peut ni écrire, ni choisir, ni répéter. */
    private static final String[] SANS_PIXEL = {"--image", "--lineaire", "--auto", "--repeter", "--comparer"};

    /** Une comparaison se fait à la taille de la référence, et n'écrit que l'image des différences. */
    private static final String[] SANS_COMPARER = {"--taille", "--lineaire", "--repeter", "--statistiques", "--auto"};

    /** Demandes d'un texte, sans rien dessiner ; la première rencontrée l'emporte. */
    public boolean aide;
    public boolean version;

    /** Fichiers à écrire, {@code null} si non demandés. */
    public String image;
    public String lineaire;

    public int largeur = Constantes.LARGEUR_IMAGE;
    public int hauteur = Constantes.HAUTEUR_IMAGE;
    public int reflets = Constantes.MAX_REFLETS;
    public double seuil = Constantes.SEUIL;
    public int fils = Math.min(FILS_MAX, Runtime.getRuntime().availableProcessors());
    public int repeter = 1;
    public boolean statistiques;

    /** Vrai si la couleur d'un seul pixel est demandée, dont voici la colonne et la ligne. */
    public boolean pixel;
    public int pixelX;
    public int pixelY;

    /** Vrai pour les boucles du cours, faux pour la recherche rapide. */
    public boolean simple;

    /** Vrai si le programme doit choisir ses réglages : pour une erreur voulue, ou sinon pour un temps voulu. */
    public boolean auto;

    /** L'erreur voulue, en niveaux sur 255 ; 0 si aucune. */
    public double erreurVoulue;

    /** Le temps de dessin voulu, en secondes ; 0 si aucun. */
    public double tempsVoulu;

    /** L'image à laquelle comparer, {@code null} si aucune ; et le plus grand écart permis, en niveaux sur 255. */
    public String comparer;
    public double tolerance;

    /** Vrai si le nombre de réflexions, ou le seuil, est demandé : {@code --auto} n'y touche pas. */
    public boolean refletsDonnes;
    public boolean seuilDonne;

    /** Les variantes présentes à débrancher. */
    public List<String> sans = Collections.emptyList();

    /** La scène, {@code null} si aucune n'est nommée. */
    public String scene;

    private String pixelEcrit;
    private final String[] arguments;
    private int suivant;
    private String valeurCollee;

    private Options(String[] arguments) {
        this.arguments = arguments;
    }

    /** @throws Echec si un argument ne va pas */
    public static Options lire(String... arguments) {
        Options options = new Options(arguments);
        options.lire();
        return options;
    }

    /** Vrai si un fichier est demandé : alors, pas de fenêtre. */
    public boolean versFichier() {
        return image != null || lineaire != null;
    }

    private void lire() {
        Set<String> vues = new HashSet<>();
        while (suivant < arguments.length && !aide && !version) {
            String argument = arguments[suivant++];
            if (!argument.startsWith("-")) {
                if (scene != null) {
                    throw faute("plusieurs scènes : " + Texte.cite(scene) + " et " + Texte.cite(argument)
                            + " ; attendu : une seule");
                }
                if (argument.isEmpty()) {
                    throw faute("nom de scène vide ; attendu : un fichier, par exemple scenes/scene1.ini");
                }
                scene = argument;
                continue;
            }
            int egal = argument.startsWith("--") ? argument.indexOf('=') : -1;
            String nom = egal < 0 ? argument : argument.substring(0, egal);
            valeurCollee = egal < 0 ? null : argument.substring(egal + 1);
            if (!vues.add(nom)) {
                throw faute("option donnée deux fois : " + Texte.abrege(nom)
                        + " ; attendu : une seule fois chaque option");
            }
            option(nom);
        }
        if (!aide && !version) {
            accorder(vues);
        }
    }

    /** Refuse les options qui ne vont pas ensemble, ou pas seules. */
    private void accorder(Set<String> vues) {
        if (pixel) {
            refuser(SANS_PIXEL, vues, "--pixel ne va pas avec %s");
            if (pixelX >= largeur || pixelY >= hauteur) {
                throw horsLimites("--pixel", pixelEcrit,
                        "un pixel de l'image, de 0,0 à " + (largeur - 1) + "," + (hauteur - 1));
            }
        }
        if (comparer != null) {
            if (scene == null) {
                throw faute("rien à comparer à " + Texte.cite(comparer)
                        + " ; attendu : une scène, ou une image PNG ou PFM");
            }
            refuser(SANS_COMPARER, vues, "%s ne va pas avec --comparer");
        } else if (vues.contains("--tolerance")) {
            throw faute("--tolerance ne sert pas seule ; attendu : avec elle, --comparer REFERENCE.png");
        }
        if ((versFichier() || pixel) && scene == null) {
            throw faute("aucune scène à dessiner ; attendu : un fichier, par exemple scenes/scene1.ini");
        }
        if (auto && !versFichier()) {
            throw faute("--auto ne sert pas dans la fenêtre ; attendu : avec elle, "
                    + "--image FICHIER.png ou --lineaire FICHIER.pfm");
        }
    }

    private static void refuser(String[] autres, Set<String> vues, String faute) {
        for (String autre : autres) {
            if (vues.contains(autre)) {
                throw faute(String.format(faute, autre) + " ; attendu : l'une ou l'autre");
            }
        }
    }

    private void option(String nom) {
        switch (nom) {
            case "--image":
                image = fichier(nom, ".png");
                break;
            case "--lineaire":
                lineaire = fichier(nom, ".pfm");
                break;
            case "--comparer":
                comparer = valeur(nom, "une image PNG ou PFM");
                if (!comparer.toLowerCase(Locale.ROOT).matches("(?s).*\\.(png|pfm)")) {
                    throw horsLimites(nom, comparer, "une image PNG ou PFM");
                }
                break;
            case "--tolerance":
                tolerance = positif(nom, "un nombre de niveaux positif ou nul, par exemple 1");
                break;
            case "--taille":
                taille(valeur(nom, "une taille, par exemple 800x600"));
                break;
            case "--reflets":
                reflets = entier(nom, 0, REFLETS_MAX);
                refletsDonnes = true;
                break;
            case "--seuil":
                seuil = positif(nom, "un nombre positif ou nul, par exemple 0.001");
                seuilDonne = true;
                break;
            case "--sans":
                sans = Arrays.asList(valeur(nom, "une variante, par exemple Brume").split(","));
                break;
            case "--fils":
                fils = entier(nom, 1, FILS_MAX);
                break;
            case "--repeter":
                repeter = entier(nom, 1, REPETER_MAX);
                break;
            case "--pixel":
                pixel(valeur(nom, PIXEL));
                break;
            case "--statistiques":
                statistiques = sansValeur(nom);
                break;
            case "--simple":
                simple = sansValeur(nom);
                break;
            case "--auto":
                souhait(valeur(nom, AUTO));
                auto = true;
                break;
            case "--aide":
            case "--help":
            case "-h":
                aide = sansValeur(nom);
                break;
            case "--version":
                version = sansValeur(nom);
                break;
            default:
                throw faute("option inconnue : " + Texte.cite(nom) + " ; attendu : une de celles que montre --aide");
        }
    }

    private String valeur(String nom, String attendu) {
        String valeur = valeurCollee != null ? valeurCollee : suivant < arguments.length ? arguments[suivant++] : "";
        // « --image --fils 2 » : un oubli, pas un fichier nommé « --fils »
        if (valeur.isEmpty() || valeurCollee == null && valeur.startsWith("--")) {
            throw faute("option sans sa valeur : " + nom + " ; attendu : " + attendu);
        }
        return valeur;
    }

    /** Le nom est jugé tel quel : ce qu'il y a au bout d'un lien ne compte pas. */
    private String fichier(String nom, String fin) {
        String fichier = valeur(nom, "un fichier " + fin);
        if (!fichier.toLowerCase(Locale.ROOT).endsWith(fin)) {
            throw horsLimites(nom, fichier, "un fichier dont le nom finit par " + fin);
        }
        return fichier;
    }

    /** @return vrai : l'option est demandée */
    private boolean sansValeur(String nom) {
        if (valeurCollee != null) {
            throw faute("option qui ne prend pas de valeur : " + nom + " ; reçu : " + Texte.cite(valeurCollee));
        }
        return true;
    }

    private int entier(String nom, int min, int max) {
        String attendu = "un entier de " + min + " à " + max;
        String texte = valeur(nom, attendu);
        long n = chiffres(texte);
        if (n < min || n > max) {
            throw horsLimites(nom, texte, attendu);
        }
        return (int) n;
    }

    /** L'entier écrit, −1 si ce n'en est pas un ; au-delà d'un milliard, un milliard. */
    private static long chiffres(String texte) {
        long n = 0;
        for (int i = 0; i < texte.length(); i++) {
            char c = texte.charAt(i);
            if (c < '0' || c > '9') {
                return -1;
            }
            n = Math.min(1_000_000_000, 10 * n + (c - '0'));
        }
        return texte.isEmpty() ? -1 : n;
    }

    private double positif(String nom, String attendu) {
        String texte = valeur(nom, attendu.replaceFirst(",.*", ""));
        double valeur = Nombre.lire(texte);
        if (!(valeur >= 0 && valeur <= Double.MAX_VALUE)) {
            throw horsLimites(nom, texte, attendu);
        }
        return valeur;
    }

    private void souhait(String texte) {
        if (texte.startsWith("erreur=")) {
            erreurVoulue = Nombre.lire(texte.substring("erreur=".length()));
            if (erreurVoulue >= ERREUR_MIN && erreurVoulue <= ERREUR_MAX) {
                return;
            }
        } else if (texte.startsWith("temps=") && texte.endsWith("s")) {
            int unite = texte.length() - (texte.endsWith("ms") ? 2 : 1);
            tempsVoulu = Nombre.lire(texte.substring("temps=".length(), unite)) / (texte.endsWith("ms") ? 1000 : 1);
            if (tempsVoulu >= TEMPS_MIN && tempsVoulu <= TEMPS_MAX) {
                return;
            }
        }
        throw horsLimites("--auto", texte, AUTO);
    }

    private void pixel(String texte) {
        long[] xy = deuxEntiers(texte, ',');
        if (xy[0] < 0 || xy[1] < 0) {
            throw horsLimites("--pixel", texte, PIXEL);
        }
        pixel = true;
        pixelEcrit = texte;
        pixelX = (int) xy[0];
        pixelY = (int) xy[1];
    }

    private void taille(String texte) {
        long[] cotes = deuxEntiers(texte, 'x');
        if (Math.min(cotes[0], cotes[1]) < 1 || Math.max(cotes[0], cotes[1]) > COTE_MAX
                || cotes[0] * cotes[1] > PIXELS_MAX) {
            throw horsLimites("--taille", texte, "LARGEURxHAUTEUR, par exemple 800x600, de 1 à " + COTE_MAX
                    + " chacune, et au plus " + PIXELS_MAX + " pixels");
        }
        largeur = (int) cotes[0];
        hauteur = (int) cotes[1];
    }

    /** Les deux {@link #chiffres} autour du premier séparateur, −1 s'il manque. */
    private static long[] deuxEntiers(String texte, char separateur) {
        int k = texte.indexOf(separateur);
        return k < 0 ? new long[] {-1, -1}
                : new long[] {chiffres(texte.substring(0, k)), chiffres(texte.substring(k + 1))};
    }

    private static Echec horsLimites(String nom, String texte, String attendu) {
        return faute("valeur impossible pour " + nom + " : " + Texte.cite(texte) + " ; attendu : " + attendu);
    }

    private static Echec faute(String message) {
        return new Echec(CodeSortie.DEMANDE, message);
    }
}
