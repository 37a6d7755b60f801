package lancer.auto;

import java.util.Locale;

/** Ce qui est voulu d'une image, et ce qui est fixé d'avance ; et ce qu'il y a à en dire. Immuable. */
public final class Souhait {

    /** L'erreur voulue, en niveaux, ou le temps voulu, essais et dessin, en secondes ; l'autre est nul. */
    final double erreur;
    final double temps;

    /** {@code null} : à choisir. */
    final Integer reflets;
    final Double seuil;

    private Souhait(double erreur, double temps, Integer reflets, Double seuil) {
        this.erreur = erreur;
        this.temps = temps;
        this.reflets = reflets;
        this.seuil = seuil;
    }

    /** Au meilleur prix, une erreur d'au plus tant de niveaux. */
    public static Souhait erreur(double niveaux) {
        return new Souhait(niveaux, 0, null, null);
    }

    /** Au plus juste, une image en au plus tant de secondes, essais compris. */
    public static Souhait temps(double secondes) {
        return new Souhait(0, secondes, null, null);
    }

    /** Le même, à tant de réflexions et à ce seuil ; {@code null} pour celui des deux qui reste à choisir. */
    public Souhait fixer(Integer reflets, Double seuil) {
        return new Souhait(erreur, temps, reflets, seuil);
    }

    /** Pourquoi un réglage est choisi, entre tant d'essayés. @param tenable s'il devrait tenir ce qui est voulu */
    String raison(boolean tenable, int essayes) {
        String voulu = erreur > 0 ? texte("une erreur de %.2f", erreur) : texte("%.3f s", temps);
        if (essayes == 1) {
            return "seul réglage essayé, qui " + (tenable ? "promet " : "ne promet pas ") + voulu;
        }
        return tenable ? (erreur > 0 ? "le moins cher" : "le plus juste") + " de " + essayes
                + " réglages essayés pour " + voulu : "aucun de " + essayes + " réglages essayés ne promet " + voulu
                + ", voici le plus " + (erreur > 0 ? "juste" : "rapide");
    }

    /** Si une image le tient. @param mesuree son erreur, et {@code temps} celui des essais et du dessin, en secondes */
    String verdict(Estimation mesuree, double temps) {
        if (erreur == 0) {
            return "temps voulu " + (temps <= this.temps ? "tenu" : "dépassé");
        }
        if (mesuree.erreur() + mesuree.incertitude() <= erreur) {
            return "erreur voulue tenue";
        }
        return mesuree.erreur() - mesuree.incertitude() > erreur ? "erreur voulue dépassée"
                : "on ne peut dire si l'erreur voulue est tenue";
    }

    /** Toujours avec un point, quelle que soit la langue. */
    static String texte(String format, Object... valeurs) {
        return String.format(Locale.ROOT, format, valeurs);
    }
}
