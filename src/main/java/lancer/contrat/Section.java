package lancer.contrat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Couleur;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Vecteur;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/**
 * Une section d'un fichier de scène : des clés et leurs valeurs, lues avec leur type et leurs limites. Toute valeur
 * refusée l'est par une {@link SceneFautive} d'une ligne. Une clé inconnue est refusée dès qu'elle est lue si la
 * section sait d'avance les siennes (celle d'un objet ou d'une lampe), sinon à la fin, si personne ne l'a demandée
 * ({@link #verifierCles}).
 */
public final class Section {

    /** Plus grande coordonnée d'un point ou d'une direction, en unités de la scène. */
    private static final double COORDONNEE_MAX = 1e100;
    private static final double LONGUEUR_MIN = 1e-100;
    private static final double LONGUEUR_MAX = 1e100;

    /** Le plus petit nombre strictement positif. */
    private static final double PLUS_QUE_ZERO = Double.MIN_VALUE;

    /** Nombre de clés au plus, qu'aucune section n'atteint : chercher les doublons coûterait ensuite trop cher. */
    private static final int CLES_MAX = 64;

    /** Nom tenant lieu de fichier à une section qui n'est dans aucun. */
    private static final String REGLAGE = "réglage";

    private final String fichier;
    private final String nom;
    private final int ligne;
    /** Dit si elle n'apprend ses clés qu'à mesure qu'on les demande. */
    private final boolean ouverte;
    private final List<String> connues;
    private final List<String> cles = new ArrayList<>(5);
    private final List<String> valeurs = new ArrayList<>(5);
    private final List<Integer> lignes = new ArrayList<>(5);

    /**
     * @param nom tel qu'écrit entre les crochets
     * @param ligne celle des crochets, 0 si la section n'est pas dans le fichier
     */
    public Section(String fichier, String nom, int ligne) {
        this(fichier, nom, ligne, null);
    }

    /** @param connues les seules clés permises, et à demander ; {@code null} : celles qui seront demandées */
    public Section(String fichier, String nom, int ligne, String[] connues) {
        this.fichier = fichier;
        this.nom = nom;
        this.ligne = ligne;
        ouverte = connues == null;
        this.connues = ouverte ? new ArrayList<>() : Arrays.asList(connues);
    }

    /**
     * Une section qui n'est dans aucun fichier, pour {@link Variante#getEchelle}.
     *
     * @param type celui de la section, par exemple {@code Antialias}
     * @param clesEtValeurs une clé, sa valeur, une autre clé, sa valeur…
     */
    public static Section sansFichier(String type, String... clesEtValeurs) {
        Section section = new Section(REGLAGE, type, 0);
        for (int k = 0; k + 1 < clesEtValeurs.length; k += 2) {
            section.ajouter(clesEtValeurs[k], clesEtValeurs[k + 1], 0);
        }
        return section;
    }

    /** Le nom, tel qu'écrit entre les crochets. */
    public String getNom() {
        return nom;
    }

    /** La ligne des crochets. */
    public int getLigne() {
        return ligne;
    }

    public void ajouter(String cle, String valeur, int ligneCle) {
        int deja = rang(cle, cles);
        if (deja >= 0) {
            throw fautive(ligneCle, cle, "clé donnée deux fois, déjà ligne " + lignes.get(deja),
                    "une seule fois chaque clé");
        }
        if (!ouverte && rang(cle, connues) < 0) {
            throw inconnue(ligneCle, cle);
        }
        if (cles.size() == CLES_MAX) {
            throw fautive(ligneCle, cle, "trop de clés", "au plus " + CLES_MAX + " clés dans une section");
        }
        cles.add(cle);
        valeurs.add(valeur);
        lignes.add(ligneCle);
    }

    private SceneFautive inconnue(int ligneCle, String cle) {
        return fautive(ligneCle, cle, "clé inconnue",
                connues.isEmpty() ? "aucune clé" : String.join(", ", connues));
    }

    private static int rang(String cle, List<String> parmi) {
        for (int k = 0; k < parmi.size(); k++) {
            if (parmi.get(k).equalsIgnoreCase(cle)) {
                return k;
            }
        }
        return -1;
    }

    /** Dit si la section donne cette clé. La clé est alors connue, qu'on lise ou non sa valeur. */
    public boolean contient(String cle) {
        return demander(cle) >= 0;
    }

    private int demander(String cle) {
        if (rang(cle, connues) < 0) {
            if (!ouverte) {
                throw new IllegalStateException("getCles ne nomme pas la clé " + cle);
            }
            connues.add(cle);
        }
        return rang(cle, cles);
    }

    /**
     * Le nombre de cette clé.
     *
     * @param defaut sa valeur si elle n'est pas donnée
     * @param min plus petite valeur permise
     * @param max plus grande valeur permise
     */
    public double reel(String cle, double defaut, double min, double max) {
        return contient(cle) ? reel(cle, min, max) : defaut;
    }

    /** Lit comme {@link #reel(String, double, double, double)}, la clé étant obligatoire. */
    public double reel(String cle, double min, double max) {
        return nombres(cle, 1, min, max)[0];
    }

    /** Lit comme {@link #reel(String, double, double, double)}, la valeur étant strictement positive. */
    public double reelPositif(String cle, double defaut, double max) {
        return reel(cle, defaut, PLUS_QUE_ZERO, max);
    }

    /** Lit comme {@link #reel(String, double, double, double)}, la valeur étant un nombre entier. */
    public int entier(String cle, int defaut, int min, int max) {
        double valeur = reel(cle, defaut, min, max);
        if (valeur != (int) valeur) {
            throw fautive(cle, "n'est pas un nombre entier : " + Texte.cite(mot(cle, "")),
                    "un entier de " + min + " à " + max);
        }
        return (int) valeur;
    }

    /** La couleur de cette clé, trois nombres de 0 à {@code max}. */
    public Couleur couleur(String cle, Couleur defaut, double max) {
        return contient(cle) ? couleur(cle, max) : defaut;
    }

    /** Lit comme {@link #couleur(String, Couleur, double)}, la clé étant obligatoire. */
    public Couleur couleur(String cle, double max) {
        double[] n = nombres(cle, 3, 0, max);
        return new Couleur(n[0], n[1], n[2]);
    }

    /** Le point de cette clé, obligatoire : trois coordonnées de −1e100 à 1e100. */
    public Point point(String cle) {
        double[] n = nombres(cle, 3, -COORDONNEE_MAX, COORDONNEE_MAX);
        return new Point(n[0], n[1], n[2]);
    }

    /** La direction de cette clé, obligatoire : un vecteur qui n'est pas nul, ramené à la longueur 1. */
    public Vecteur direction(String cle) {
        Point p = point(cle);
        if (p.x == 0 && p.y == 0 && p.z == 0) {
            throw fautive(cle, "vecteur nul : " + Texte.cite(mot(cle, "")), "trois nombres qui ne sont pas tous nuls");
        }
        return new Vecteur(p.x, p.y, p.z).normalized();
    }

    /** La longueur de cette clé, obligatoire : de 1e-100 à 1e100. */
    public double longueur(String cle) {
        return reel(cle, LONGUEUR_MIN, LONGUEUR_MAX);
    }

    /** Le mot de cette clé, tel qu'écrit. */
    public String mot(String cle, String defaut) {
        int k = demander(cle);
        return k < 0 ? defaut : valeurs.get(k);
    }

    private double[] nombres(String cle, int combien, double min, double max) {
        int k = demander(cle);
        if (k < 0) {
            throw fautive(ligne, cle, "clé absente", attendu(combien, min, max));
        }
        String texte = valeurs.get(k);
        double[] nombres = new double[combien];
        int trouves = 0;
        int fin = 0;
        for (int debut = fin(texte, 0, true); debut < texte.length(); debut = fin(texte, fin, true)) {
            fin = fin(texte, debut, false);
            double valeur = Nombre.lire(texte, debut, fin);
            if (!(valeur >= min && valeur <= max)) {
                throw impossible(k, texte.substring(debut, fin), valeur, attendu(combien, min, max));
            }
            if (trouves < combien) {
                nombres[trouves] = valeur;
            }
            trouves++;
        }
        if (trouves != combien) {
            String faute = trouves == 0 ? "valeur absente"
                    : trouves + (trouves > 1 ? " nombres" : " nombre") + " au lieu de " + combien + " : "
                    + Texte.cite(texte);
            throw fautive(lignes.get(k), cles.get(k), faute, attendu(combien, min, max));
        }
        return nombres;
    }

    /** Indice où finissent les blancs, ou ce qui n'en est pas, qui commencent là. */
    private static int fin(String texte, int debut, boolean blancs) {
        int i = debut;
        while (i < texte.length() && (texte.charAt(i) == ' ' || texte.charAt(i) == '\t') == blancs) {
            i++;
        }
        return i;
    }

    /** Refuse un mot, en nommant les fautes les plus courantes. */
    private SceneFautive impossible(int k, String mot, double valeur, String attendu) {
        String faute = Texte.cite(mot);
        String voulu = attendu;
        if (!Double.isNaN(valeur)) {
            faute = (Double.isInfinite(valeur) ? "nombre trop grand : " : "hors limites : ") + faute;
        } else if (mot.startsWith(";") || mot.startsWith("#")) {
            String texte = valeurs.get(k);
            faute = "commentaire après une valeur : " + Texte.cite(texte.substring(texte.indexOf(mot)));
            voulu = "un commentaire seul sur sa ligne";
        } else {
            boolean virgule = mot.indexOf(',') >= 0;
            faute = (virgule ? "une virgule dans un nombre : " : "n'est pas un nombre : ") + faute;
            voulu += virgule ? ", avec un point décimal" : "";
        }
        return fautive(lignes.get(k), cles.get(k), faute, voulu);
    }

    private static String attendu(int combien, double min, double max) {
        String nombres = combien == 1 ? "un nombre" : combien + " nombres séparés par des blancs, chacun";
        boolean borne = max < Double.MAX_VALUE;
        if (min == PLUS_QUE_ZERO) {
            return nombres + " plus grand que 0" + (borne ? ", au plus " + Nombre.ecrire(max) : "");
        }
        return borne ? nombres + " de " + Nombre.ecrire(min) + " à " + Nombre.ecrire(max)
                : nombres + " d'au moins " + Nombre.ecrire(min);
    }

    /** Refuse les clés données que personne n'a demandées. */
    public void verifierCles() {
        for (int k = 0; k < cles.size(); k++) {
            if (rang(cles.get(k), connues) < 0) {
                throw inconnue(lignes.get(k), cles.get(k));
            }
        }
    }

    /**
     * Refus de la valeur d'une clé, pour une raison que cette classe ne connaît pas.
     *
     * @param cle présente ou non
     * @param faute ce qui ne va pas
     * @param attendu ce qu'il faudrait
     */
    public SceneFautive fautive(String cle, String faute, String attendu) {
        int k = rang(cle, cles);
        return fautive(k < 0 ? ligne : lignes.get(k), cle, faute, attendu);
    }

    /** Deux clés qui ne vont pas ensemble : c'est la seconde écrite qui est de trop. */
    public SceneFautive ensemble(String cle, String autre, String faute, String attendu) {
        int premiere = Math.min(rang(cle, cles), rang(autre, cles));
        int seconde = Math.max(rang(cle, cles), rang(autre, cles));
        return fautive(lignes.get(seconde), cles.get(seconde),
                faute + " " + cles.get(premiere) + ", déjà ligne " + lignes.get(premiere), attendu);
    }

    /** Texte de la section, comme dans un fichier mais sur une ligne : {@code [Antialias] n=8 methode=partage}. */
    @Override
    public String toString() {
        return ecrire(" ");
    }

    /** Texte de la section, comme dans un fichier, {@code separateur} entre deux clés. */
    public String ecrire(String separateur) {
        StringBuilder s = new StringBuilder("[" + nom + "]");
        for (int k = 0; k < cles.size(); k++) {
            s.append(separateur).append(cles.get(k)).append('=').append(valeurs.get(k));
        }
        return s.toString();
    }

    /** La valeur de cette clé, telle qu'écrite, {@code null} si elle n'est pas donnée ; ce n'est pas la demander. */
    public String valeur(String cle) {
        int k = rang(cle, cles);
        return k < 0 ? null : valeurs.get(k);
    }

    /**
     * Section identique, où cette clé a cette valeur.
     *
     * @param sans une clé à ôter, ou {@code null}
     */
    public Section avec(String cle, String valeur, String sans) {
        Section autre = new Section(REGLAGE, nom, 0);
        for (int k = 0; k < cles.size(); k++) {
            if (k != rang(cle, cles) && (sans == null || k != rang(sans, cles))) {
                autre.ajouter(cles.get(k), valeurs.get(k), 0);
            }
        }
        autre.ajouter(cle, valeur, 0);
        return autre;
    }

    public SceneFautive fautive(int ligneFaute, String cle, String faute, String attendu) {
        return new SceneFautive(message(fichier, ligneFaute, nom, cle, faute, attendu));
    }

    /** Le message de toute faute d'un fichier de scène ; {@code ligne} 0, {@code nom}, {@code cle} null : inconnus. */
    public static String message(String fichier, int ligne, String nom, String cle, String faute, String attendu) {
        return Texte.echappe(fichier)
                + (ligne > 0 ? ", ligne " + ligne : "")
                + (nom != null ? ", [" + Texte.abrege(nom) + "]" : "")
                + (cle != null ? ", " + Texte.abrege(cle) : "")
                + " : " + faute + " ; attendu : " + attendu;
    }
}
