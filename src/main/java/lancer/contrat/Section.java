package lancer.contrat;

import lancer.Couleur;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Vecteur;
import lancer.texte.Texte;

/** Une section de scène, lue par clé. Une valeur refusée ou une clé inconnue lève une {@link SceneFautive}. */
public abstract class Section {

    /** Plus grande coordonnée d'un point ou d'une direction, et plus grande longueur, en unités de la scène. */
    private static final double COORDONNEE_MAX = 1e100;

    /** Le nom entre les crochets et sa ligne, 0 si la section n'est pas dans le fichier. */
    public final String nom;
    public final int ligne;

    protected Section(String nom, int ligne) {
        this.nom = nom;
        this.ligne = ligne;
    }

    /** Une section de même nom qui n'est dans aucun fichier : une clé, sa valeur, une autre clé, sa valeur… */
    public abstract Section sansFichier(String... clesEtValeurs);

    /** Le mot de cette clé, comme dans le fichier. */
    public abstract String mot(String cle, String defaut);

    /** Dit si la section donne cette clé. La clé est alors connue, même si sa valeur n'est pas lue. */
    public boolean contient(String cle) {
        return mot(cle, null) != null;
    }

    /** Les nombres de cette clé, obligatoire, chacun de {@code min} à {@code max}. */
    protected abstract double[] nombres(String cle, int combien, double min, double max);

    /** Le nombre de cette clé, de {@code min} à {@code max} ; {@code defaut} si la clé n'est pas donnée. */
    public double reel(String cle, double defaut, double min, double max) {
        return contient(cle) ? nombres(cle, 1, min, max)[0] : defaut;
    }

    /** Lit comme {@link #reel} un nombre entier. */
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

    /** Lit comme {@link #couleur(String, Couleur, double)} une clé obligatoire. */
    public Couleur couleur(String cle, double max) {
        double[] n = nombres(cle, 3, 0, max);
        return new Couleur(n[0], n[1], n[2]);
    }

    /** Le point de cette clé, obligatoire : trois coordonnées de −1e100 à 1e100. */
    public Point point(String cle) {
        double[] n = nombres(cle, 3, -COORDONNEE_MAX, COORDONNEE_MAX);
        return new Point(n[0], n[1], n[2]);
    }

    /** La direction de cette clé, obligatoire : un vecteur non nul, ramené à la longueur 1. */
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

    /** Refuse les clés données que rien n'a lues. */
    public abstract void verifierCles();

    /** Refus d'une clé, présente ou non. @param faute ce qui est faux @param attendu ce qui est attendu */
    public abstract SceneFautive fautive(String cle, String faute, String attendu);

    /** Section identique, où {@code cle} vaut {@code valeur}. @param sans clé à ôter, ou {@code null} */
    public abstract Section avec(String cle, String valeur, String sans);

    /** Texte de la section, comme dans un fichier, avec {@code separateur} entre deux clés. */
    public abstract String ecrire(String separateur);

    /** Texte de la section sur une ligne : {@code [Antialias] n=8 methode=partage}. */
    @Override
    public final String toString() {
        return ecrire(" ");
    }

    /** Deux sections de même texte sont égales, où qu'elles soient écrites. */
    @Override
    public final boolean equals(Object autre) {
        return autre instanceof Section && toString().equals(autre.toString());
    }

    @Override
    public final int hashCode() {
        return toString().hashCode();
    }
}
