package lancer.contrat;

import lancer.Couleur;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Vecteur;
import lancer.texte.Texte;

/**
 * Une section d'un fichier de scène : des clés et leurs valeurs, lues avec leur type et leurs limites. Une valeur
 * refusée, ou une clé que personne ne demande, l'est par une {@link SceneFautive} d'une ligne.
 */
public abstract class Section {

    /** Plus grande coordonnée d'un point ou d'une direction, et plus grande longueur, en unités de la scène. */
    private static final double COORDONNEE_MAX = 1e100;

    /** Le nom, tel qu'écrit entre les crochets, et leur ligne, 0 si la section n'est pas dans le fichier. */
    public final String nom;
    public final int ligne;

    protected Section(String nom, int ligne) {
        this.nom = nom;
        this.ligne = ligne;
    }

    /** Une section de ce nom, qui n'est dans aucun fichier : une clé, sa valeur, une autre clé, sa valeur… */
    public abstract Section sansFichier(String... clesEtValeurs);

    /** Le mot de cette clé, tel qu'écrit. */
    public abstract String mot(String cle, String defaut);

    /** Dit si la section donne cette clé. La clé est alors connue, qu'on lise ou non sa valeur. */
    public boolean contient(String cle) {
        return mot(cle, null) != null;
    }

    /** Les nombres de cette clé, obligatoire : tant, chacun de {@code min} à {@code max}. */
    protected abstract double[] nombres(String cle, int combien, double min, double max);

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

    /** Refuse les clés données que personne n'a demandées. */
    public abstract void verifierCles();

    /** Refus de la valeur d'une clé, présente ou non : ce qui ne va pas, et ce qu'il faudrait. */
    public abstract SceneFautive fautive(String cle, String faute, String attendu);

    /** Deux clés qui ne vont pas ensemble : c'est la seconde écrite qui est de trop. */
    public abstract SceneFautive ensemble(String cle, String autre, String faute, String attendu);

    /** La valeur de cette clé, telle qu'écrite, {@code null} si elle n'est pas donnée ; ce n'est pas la demander. */
    public abstract String valeur(String cle);

    /** Section identique, où cette clé a cette valeur, et d'où la clé {@code sans}, ou {@code null}, est ôtée. */
    public abstract Section avec(String cle, String valeur, String sans);

    /** Texte de la section, comme dans un fichier, {@code separateur} entre deux clés. */
    public abstract String ecrire(String separateur);

    /** Texte de la section, comme dans un fichier mais sur une ligne : {@code [Antialias] n=8 methode=partage}. */
    @Override
    public String toString() {
        return ecrire(" ");
    }
}
