package lancer.auto;

import java.util.Locale;

/** Les phrases de {@code --auto} : ce qui était attendu du choix et pourquoi lui, ce qui est mesuré ensuite. */
final class CompteRendu {

    private CompteRendu() {
    }

    /**
     * @param possibles nombre de réglages entre lesquels choisir
     * @param temps attendu, en secondes ; 0 si aucun n'est voulu
     */
    static String attente(Souhait souhait, Reglage choisi, int possibles, double temps) {
        return texte("erreur de %.2f, au plus %.2f ; %.2f rayons de l'écran par pixel, %.2f avec les ombres et les "
                + "reflets", choisi.getErreur(), choisi.getErreurAuPlus(), choisi.getRayons(), choisi.getPrix())
                + (temps > 0 ? texte(" ; %.3f s de dessin", temps) : "")
                + " ; " + raison(souhait, souhait.estTenu(choisi.getErreurAuPlus(), temps), possibles);
    }

    private static String raison(Souhait souhait, boolean tenable, int possibles) {
        if (possibles == 1) {
            return "seul réglage permis, qui " + (tenable ? "promet " : "ne promet pas ") + souhait;
        }
        boolean erreur = souhait.erreur > 0;
        return tenable ? (erreur ? "le moins cher" : "le plus juste") + " de " + possibles + " réglages pour " + souhait
                : "aucun de " + possibles + " réglages ne promet " + souhait + ", voici le plus "
                + (erreur ? "juste" : "rapide");
    }

    /**
     * @param pixels où l'erreur est mesurée, voir {@link #pixels}
     * @param dessin le temps du dessin, et {@code essais} celui des essais, contrôle compris, en secondes
     */
    static String controle(Souhait souhait, Estimation erreur, String pixels, double dessin, double essais) {
        String tenu = souhait.estTenu(erreur.erreur(), dessin) ? "tenu" : "dépassé";
        return texte("erreur de %.2f ± %.2f sur %s ; dessin en %.3f s, essais en %.3f s ; ", erreur.erreur(),
                erreur.ecartType(), pixels, dessin, essais)
                + (souhait.erreur > 0 ? "erreur voulue " + tenu + "e" : "temps voulu " + tenu);
    }

    /** @param autres faux si l'image est trop petite pour en avoir d'autres que ceux du choix */
    static String pixels(int controles, boolean autres, int essayes) {
        boolean un = controles == 1;
        if (!autres) {
            return un ? "le seul pixel de l'image, celui du choix"
                    : "les " + controles + " pixels de l'image, ceux du choix";
        }
        return controles + (un ? " pixel de l'image, autre" : " pixels de l'image, autres") + " que "
                + (essayes == 1 ? "celui" : "les " + essayes) + " du choix";
    }

    /** Toujours avec un point, quelle que soit la langue. */
    static String texte(String format, Object... valeurs) {
        return String.format(Locale.ROOT, format, valeurs);
    }
}
