package lancer.texte;

import java.io.File;
import java.nio.charset.Charset;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;

/** Erreurs du système et de Java à propos d'un fichier, dites en français. */
public final class ErreurSysteme {

    private ErreurSysteme() {
    }

    /** Explication, si la langue du système ne permet pas de lire ce chemin ou le dossier courant ; vide sinon. */
    public static String horsLangue(String chemin) {
        String codage = System.getProperty("sun.jnu.encoding", "UTF-8");
        return Charset.forName(codage).newEncoder().canEncode(chemin) && new File("").getAbsoluteFile().exists() ? ""
                : " (la langue du système, réglée sur " + codage
                        + ", ne permet pas de lire ce nom : mettre LC_ALL=C.UTF-8 devant la commande)";
    }

    /** La raison d'une erreur de fichier. Une erreur rare est dite par le système, dans sa langue. */
    public static String raison(Exception e) {
        if (e instanceof InvalidPathException) {
            return "nom de fichier impossible";
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
