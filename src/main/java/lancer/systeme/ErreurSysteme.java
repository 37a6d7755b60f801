package lancer.systeme;

import java.io.File;
import java.io.IOError;
import java.nio.charset.Charset;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import lancer.texte.Texte;

/** Erreurs de fichier, dites en une ligne. */
public final class ErreurSysteme {

    private ErreurSysteme() {
    }

    /** Explication, si la langue du système ne permet pas de lire ce chemin ou le dossier courant ; vide sinon. */
    public static String horsLangue(String chemin) {
        String codage = System.getProperty("sun.jnu.encoding", "UTF-8");
        boolean lisible = Charset.forName(codage).newEncoder().canEncode(chemin)
                && new File("").getAbsoluteFile().exists();
        if (Console.WINDOWS) {
            // Windows y met un ? à la place d'un caractère qu'il n'a pas
            return lisible && chemin.indexOf('?') < 0 ? ""
                    : " (Windows, réglé sur " + codage
                            + ", ne permet pas de lire ce nom de fichier ou de dossier : le changer)";
        }
        return lisible ? "" : " (la langue du système, réglée sur " + codage
                + ", ne permet pas de lire ce nom : mettre LC_ALL=C.UTF-8 devant la commande)";
    }

    /**
     * La raison d'une erreur de lecture ou d'écriture de ce fichier. Une erreur rare est dite par le système, dans sa
     * langue.
     */
    public static String raison(Throwable e, String fichier) {
        if (e instanceof InvalidPathException) {
            return "nom de fichier impossible";
        }
        if (e instanceof IOError) {
            return "ce lecteur n'existe pas";
        }
        if (new File(fichier).isDirectory()) {
            return "c'est un dossier";
        }
        if (e instanceof NoSuchFileException) {
            return "fichier introuvable";
        }
        if (e instanceof AccessDeniedException) {
            return "accès interdit";
        }
        String dit = e instanceof FileSystemException ? ((FileSystemException) e).getReason() : e.getMessage();
        return Texte.abrege(dit == null ? e.toString() : dit);
    }
}
