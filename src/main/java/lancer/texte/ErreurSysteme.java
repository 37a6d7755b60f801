package lancer.texte;

import java.io.File;
import java.nio.charset.Charset;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;

/** Erreurs du système et de Java à propos d'un fichier, dites en français. */
public final class ErreurSysteme {

    /** Traduction des messages du système et de Java. */
    private static final String[][] CONNUES = {{"No space left on device", "disque plein"},
        {"Aucun espace disponible sur le périphérique", "disque plein"},
        {"There is not enough space on the disk", "disque plein"}, {"Espace insuffisant sur le disque", "disque plein"},
        {"Disk quota exceeded", "quota de disque dépassé"}, {"File too large", "fichier trop grand"},
        {"File name too long", "nom de fichier trop long"}, {"Not a directory", "le dossier n'existe pas"},
        {"Read-only file system", "système de fichiers en lecture seule"}, {"Is a directory", "c'est un dossier"},
        {"Device or resource busy", "c'est un point de montage, que rien ne remplace"},
        {"Too many levels of symbolic links", "trop de liens symboliques"}, {"Broken pipe", "plus personne ne lit"},
        {"NoSuchFileException", "fichier introuvable"}, {"AccessDeniedException", "accès interdit"}};

    private ErreurSysteme() {
    }

    /** Explication, si la langue du système ne permet pas de lire ce chemin ou le dossier courant ; vide sinon. */
    public static String horsLangue(String chemin) {
        String codage = System.getProperty("sun.jnu.encoding", "UTF-8");
        return Charset.forName(codage).newEncoder().canEncode(chemin) && new File("").getAbsoluteFile().exists() ? ""
                : " (la langue du système, réglée sur " + codage
                        + ", ne permet pas de lire ce nom : mettre LC_ALL=C.UTF-8 devant la commande)";
    }

    /** La raison d'une erreur de fichier, en français si elle est connue ; sinon, son nom en Java. */
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
