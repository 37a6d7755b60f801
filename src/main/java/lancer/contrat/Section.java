package lancer.contrat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.StringTokenizer;
import java.util.stream.Collectors;
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

    /** Plus grande coordonnée d'un point ou d'une direction, et plus grande longueur, en unités de la scène. */
    private static final double COORDONNEE_MAX = 1e100;

    /** Nombre de clés au plus, qu'aucune section n'atteint : chercher les doublons coûterait ensuite trop cher. */
    private static final int CLES_MAX = 64;

    /** Le nom, tel qu'écrit entre les crochets. */
    public final String nom;

    /** La ligne des crochets, 0 si la section n'est pas dans le fichier. */
    public final int ligne;
    private final String fichier;
    /** Les clés permises, ou demandées jusqu'ici si toutes peuvent l'être. */
    private final List<String> connues;
    private final boolean ouverte;
    private final List<Entree> entrees = new ArrayList<>(5);

    /** Une ligne de la section. */
    private static final class Entree {

        final String cle;
        final String valeur;
        final int ligne;

        Entree(String cle, String valeur, int ligne) {
            this.cle = cle;
            this.valeur = valeur;
            this.ligne = ligne;
        }
    }

    /** @param connues les seules clés permises, et à demander ; aucune : celles qui seront demandées */
    public Section(String fichier, String nom, int ligne, String... connues) {
        this.fichier = fichier;
        this.nom = nom;
        this.ligne = ligne;
        this.connues = new ArrayList<>(Arrays.asList(connues));
        ouverte = connues.length == 0;
    }

    /** Une section de ce type, qui n'est dans aucun fichier : une clé, sa valeur, une autre clé, sa valeur… */
    public static Section sansFichier(String type, String... clesEtValeurs) {
        Section section = new Section("réglage", type, 0);
        for (int k = 0; k + 1 < clesEtValeurs.length; k += 2) {
            section.ajouter(clesEtValeurs[k], clesEtValeurs[k + 1], 0);
        }
        return section;
    }

    public void ajouter(String cle, String valeur, int ligneCle) {
        Entree deja = entree(cle);
        if (deja != null) {
            throw fautive(ligneCle, cle, "clé donnée deux fois, déjà ligne " + deja.ligne, "une seule fois chaque clé");
        }
        if (!ouverte && !estConnue(cle)) {
            throw inconnue(ligneCle, cle);
        }
        if (entrees.size() == CLES_MAX) {
            throw fautive(ligneCle, cle, "trop de clés", "au plus " + CLES_MAX + " clés dans une section");
        }
        entrees.add(new Entree(cle, valeur, ligneCle));
    }

    private SceneFautive inconnue(int ligneCle, String cle) {
        return fautive(ligneCle, cle, "clé inconnue", connues.isEmpty() ? "aucune clé" : String.join(", ", connues));
    }

    private Entree entree(String cle) {
        for (Entree entree : entrees) {
            if (pareilles(entree.cle, cle)) {
                return entree;
            }
        }
        return null;
    }

    private boolean estConnue(String cle) {
        for (String connue : connues) {
            if (pareilles(connue, cle)) {
                return true;
            }
        }
        return false;
    }

    /** Dit si ces clés sont la même, à la casse près des lettres sans accent : le signe kelvin n'est pas un k. */
    private static boolean pareilles(String cle, String autre) {
        return cle.equals(autre) || cle.equalsIgnoreCase(autre)
                && StandardCharsets.US_ASCII.newEncoder().canEncode(cle + autre);
    }

    /** Dit si la section donne cette clé. La clé est alors connue, qu'on lise ou non sa valeur. */
    public boolean contient(String cle) {
        return demander(cle) != null;
    }

    private Entree demander(String cle) {
        if (!estConnue(cle)) {
            if (!ouverte) {
                throw new IllegalStateException("getCles ne nomme pas la clé " + cle);
            }
            connues.add(cle);
        }
        return entree(cle);
    }

    /** Le nombre de cette clé, de {@code min} à {@code max} ; {@code defaut} si elle n'est pas donnée. */
    public double reel(String cle, double defaut, double min, double max) {
        return contient(cle) ? nombres(cle, 1, min, max)[0] : defaut;
    }

    /** Lit comme {@link #reel}, la valeur étant strictement positive. */
    public double reelPositif(String cle, double defaut, double max) {
        return reel(cle, defaut, Double.MIN_VALUE, max);
    }

    /** Lit comme {@link #reel}, la valeur étant un nombre entier. */
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
        return nombres(cle, 1, 1 / COORDONNEE_MAX, COORDONNEE_MAX)[0];
    }

    /** Le mot de cette clé, tel qu'écrit. */
    public String mot(String cle, String defaut) {
        Entree entree = demander(cle);
        return entree == null ? defaut : entree.valeur;
    }

    private double[] nombres(String cle, int combien, double min, double max) {
        Entree entree = demander(cle);
        if (entree == null) {
            throw fautive(ligne, cle, "clé absente", attendu(combien, min, max));
        }
        StringTokenizer mots = new StringTokenizer(entree.valeur, " \t");
        int trouves = mots.countTokens();
        double[] nombres = new double[trouves];
        for (int k = 0; k < trouves; k++) {
            String mot = mots.nextToken();
            nombres[k] = Nombre.lire(mot);
            if (!(nombres[k] >= min && nombres[k] <= max)) {
                throw impossible(entree, mot, nombres[k], attendu(combien, min, max));
            }
        }
        if (trouves != combien) {
            String faute = trouves == 0 ? "valeur absente" : trouves + (trouves > 1 ? " nombres" : " nombre")
                    + " au lieu de " + combien + " : " + Texte.cite(entree.valeur);
            throw fautive(entree.ligne, entree.cle, faute, attendu(combien, min, max));
        }
        return nombres;
    }

    /** Refuse un mot, en nommant les fautes les plus courantes. */
    private SceneFautive impossible(Entree entree, String mot, double valeur, String attendu) {
        String faute = Texte.cite(mot);
        String voulu = attendu;
        if (!Double.isNaN(valeur)) {
            faute = (Double.isInfinite(valeur) ? "nombre trop grand : " : "hors limites : ") + faute;
        } else if (mot.startsWith(";") || mot.startsWith("#")) {
            faute = "commentaire après une valeur : " + Texte.cite(entree.valeur.substring(entree.valeur.indexOf(mot)));
            voulu = "un commentaire seul sur sa ligne";
        } else {
            boolean virgule = mot.indexOf(',') >= 0;
            faute = (virgule ? "une virgule dans un nombre : " : "n'est pas un nombre : ") + faute;
            voulu += virgule ? ", avec un point décimal" : "";
        }
        return fautive(entree.ligne, entree.cle, faute, voulu);
    }

    private static String attendu(int combien, double min, double max) {
        String nombres = combien == 1 ? "un nombre" : combien + " nombres séparés par des blancs, chacun";
        boolean borne = max < Double.MAX_VALUE;
        if (min == Double.MIN_VALUE) {
            return nombres + " plus grand que 0" + (borne ? ", au plus " + Nombre.ecrire(max) : "");
        }
        return nombres + (borne ? " de " + Nombre.ecrire(min) + " à " + Nombre.ecrire(max)
                : " d'au moins " + Nombre.ecrire(min));
    }

    /** Refuse les clés données que personne n'a demandées. */
    public void verifierCles() {
        for (Entree entree : entrees) {
            if (!estConnue(entree.cle)) {
                throw inconnue(entree.ligne, entree.cle);
            }
        }
    }

    /** Refus de la valeur d'une clé, présente ou non : ce qui ne va pas, et ce qu'il faudrait. */
    public SceneFautive fautive(String cle, String faute, String attendu) {
        Entree entree = entree(cle);
        return fautive(entree == null ? ligne : entree.ligne, cle, faute, attendu);
    }

    /** Deux clés qui ne vont pas ensemble : c'est la seconde écrite qui est de trop. */
    public SceneFautive ensemble(String cle, String autre, String faute, String attendu) {
        boolean dansLOrdre = entrees.indexOf(entree(cle)) < entrees.indexOf(entree(autre));
        Entree premiere = entree(dansLOrdre ? cle : autre);
        Entree seconde = entree(dansLOrdre ? autre : cle);
        return fautive(seconde.ligne, seconde.cle, faute + " " + premiere.cle + ", déjà ligne " + premiere.ligne,
                attendu);
    }

    /** Texte de la section, comme dans un fichier mais sur une ligne : {@code [Antialias] n=8 methode=partage}. */
    @Override
    public String toString() {
        return ecrire(" ");
    }

    /** Texte de la section, comme dans un fichier, {@code separateur} entre deux clés. */
    public String ecrire(String separateur) {
        return entrees.stream().map(entree -> separateur + entree.cle + '=' + entree.valeur)
                .collect(Collectors.joining("", "[" + nom + "]", ""));
    }

    /** La valeur de cette clé, telle qu'écrite, {@code null} si elle n'est pas donnée ; ce n'est pas la demander. */
    public String valeur(String cle) {
        Entree entree = entree(cle);
        return entree == null ? null : entree.valeur;
    }

    /** Section identique, où cette clé a cette valeur, et d'où la clé {@code sans}, ou {@code null}, est ôtée. */
    public Section avec(String cle, String valeur, String sans) {
        Section autre = sansFichier(nom);
        for (Entree entree : entrees) {
            if (!entree.cle.equalsIgnoreCase(cle) && !entree.cle.equalsIgnoreCase(sans)) {
                autre.ajouter(entree.cle, entree.valeur, 0);
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
