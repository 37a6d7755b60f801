package lancer.texte;

import java.io.File;
import java.nio.charset.Charset;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;

/** Erreurs du système et de Java à propos d'un fichier, dites en français. */
public final class ErreurSysteme {

    /** Ce que Java ou le système disent en anglais, et qui arrive dans une salle de cours. */
    private static final String[][] CONNUES = {{"No space left on device", "disque plein"},
        {"Disk quota exceeded", "quota de disque dépassé"}, {"Not a directory", "le dossier n'existe pas"},
        {"Is a directory", "c'est un dossier"}, {"NoSuchFileException", "fichier introuvable"},
        {"AccessDeniedException", "accès interdit"}};

    private ErreurSysteme() {
    }

    /** Explication, si la langue du système ne permet pas de lire ce chemin ou le dossier courant ; vide sinon. */
    public static String horsLangue(String chemin) {
        String codage = System.getProperty("sun.jnu.encoding", "UTF-8");
        return Charset.forName(codage).newEncoder().canEncode(chemin) && new File("").getAbsoluteFile().exists() ? ""
                : " (la langue du système, réglée sur " + codage
                        + ", ne permet pas de lire ce nom : mettre LC_ALL=C.UTF-8 devant la commande)";
    }

    /** La raison d'une erreur de fichier, en français si elle est connue ; sinon, telle que le système la dit. */
    public static String raison(Exception e) {
        if (e instanceof InvalidPathException) {
            return "nom de fichier impossible";
        }
        String dit = e instanceof FileSystemException ? ((FileSystemException) e).getReason() : e.getMessage();
        String texte = dit == null ? e.getClass().getSimpleName() : dit;
        for (String[] connue : CONNUES) {
            if (texte.startsWith(connue[0])) {
                return connue[1];
            }
        }
        return Texte.abrege(texte);
    }
}
