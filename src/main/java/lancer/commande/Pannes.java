package lancer.commande;

import java.io.File;
import lancer.Constantes;
import lancer.contrat.PixelFautif;
import lancer.texte.Texte;

/** Ce qu'il faut dire d'un pixel qui n'a pu être calculé. */
public final class Pannes {

    private Pannes() {
    }

    /**
     * Une ligne : le pixel et la scène, la cause la plus profonde et l'endroit du code, et la commande qui dessine ce
     * pixel de nouveau.
     *
     * @param options celles du dessin
     * @param scene le fichier dessiné
     * @param largeur la taille de l'image, en pixels
     */
    public static String duPixel(PixelFautif panne, Options options, String scene, int largeur, int hauteur) {
        Throwable cause = panne;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        StringBuilder s = new StringBuilder("pixel " + panne.x + ", " + panne.y + " de " + Texte.echappe(scene)
                + " : ");
        s.append(Texte.echappe(cause.toString())).append(endroit(cause));
        s.append(" ; pour le revoir : ").append(programme());
        s.append(" --pixel ").append(panne.x).append(',').append(panne.y);
        if (largeur != Constantes.LARGEUR_IMAGE || hauteur != Constantes.HAUTEUR_IMAGE) {
            s.append(" --taille ").append(largeur).append('x').append(hauteur);
        }
        if (options.refletsDonnes) {
            s.append(" --reflets ").append(options.reflets);
        }
        if (options.seuilDonne) {
            s.append(" --seuil ").append(options.seuil);
        }
        return s.append(' ').append(motDeCommande(scene)).toString();
    }

    /** La première ligne de code qui ne soit pas de Java. */
    private static String endroit(Throwable cause) {
        for (StackTraceElement pas : cause.getStackTrace()) {
            if (!pas.getClassName().matches("(java|javax|jdk|sun)\\..*")) {
                return " (" + pas.getClassName() + "." + pas.getMethodName() + ", " + pas.getFileName() + ":"
                        + pas.getLineNumber() + ")";
            }
        }
        return "";
    }

    private static String programme() {
        String chemin = System.getProperty("java.class.path");
        return chemin.endsWith(".jar") && !chemin.contains(File.pathSeparator) ? "java -jar " + motDeCommande(chemin)
                : "java -cp " + motDeCommande(chemin) + " lancer.Main";
    }

    private static String motDeCommande(String mot) {
        return mot.matches("[\\w./:+-]+") ? mot : "'" + mot.replace("'", "'\\''") + "'";
    }
}
