package lancer.auto;

import java.util.Locale;

/** Les phrases de {@code --auto} : ce qui était attendu du choix et pourquoi lui, ce qui est mesuré ensuite. */
final class CompteRendu {

    private CompteRendu() {
    }

    /**
     * @param essayes nombre de réglages entre lesquels choisir
     * @param temps attendu, en secondes ; 0 si aucun n'est voulu
     */
    static String attente(Souhait souhait, Reglage choisi, int essayes, double temps) {
        return texte("erreur d'au plus %.2f, sans doute %.2f ; %.2f rayons de l'écran par pixel, %.2f avec les ombres "
                + "et les reflets", choisi.getErreurAuPlus(), choisi.getErreur(), choisi.getRayons(), choisi.getPrix())
                + (temps > 0 ? texte(" ; %.3f s, essais compris", temps) : "")
                + " ; " + raison(souhait, souhait.estTenu(choisi.getErreurAuPlus(), temps), essayes);
    }

    private static String raison(Souhait souhait, boolean tenable, int essayes) {
        if (essayes == 1) {
            return "seul réglage essayé, qui " + (tenable ? "promet " : "ne promet pas ") + souhait;
        }
        boolean erreur = souhait.erreur > 0;
        return tenable ? (erreur ? "le moins cher" : "le plus juste") + " de " + essayes + " réglages essayés pour "
                + souhait : "aucun de " + essayes + " réglages essayés ne promet " + souhait + ", voici le plus "
                + (erreur ? "juste" : "rapide");
    }

    /**
     * @param erreur {@code null} si le temps manquait pour la mesurer
     * @param pixels nombre de ceux où elle est mesurée
     * @param dessin le temps du dessin, et {@code essais} celui des essais, contrôle compris, en secondes
     */
    static String controle(Souhait souhait, Estimation erreur, int pixels, double dessin, double essais) {
        String mesure = erreur == null ? "erreur non mesurée, faute de temps"
                : texte("erreur de %.2f ± %.2f, sur %d pixel%s", erreur.erreur(), erreur.incertitude(), pixels,
                        pixels > 1 ? "s" : "");
        return mesure + texte(" ; dessin en %.3f s, essais en %.3f s ; ", dessin, essais)
                + (souhait.erreur > 0 ? verdict(souhait.erreur, erreur)
                : "temps voulu " + (dessin + essais <= souhait.temps ? "tenu" : "dépassé"));
    }

    private static String verdict(double voulue, Estimation erreur) {
        if (erreur.erreur() + erreur.incertitude() <= voulue) {
            return "erreur voulue tenue";
        }
        return erreur.erreur() - erreur.incertitude() > voulue ? "erreur voulue dépassée"
                : "on ne peut dire si l'erreur voulue est tenue";
    }

    /** Toujours avec un point, quelle que soit la langue. */
    static String texte(String format, Object... valeurs) {
        return String.format(Locale.ROOT, format, valeurs);
    }
}
