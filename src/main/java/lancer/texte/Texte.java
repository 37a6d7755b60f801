package lancer.texte;

import java.io.File;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.FileSystemException;
import java.util.Locale;

/** Prépare un texte d'un fichier ou de la ligne de commande pour un message d'une ligne. */
public final class Texte {

    /** Longueur au-delà de laquelle une citation est coupée, en caractères. */
    private static final int CITATION_MAX = 60;

    /** Les noms des classes qui ne font pas partie de Java, pour {@link #cause}. */
    public static final String HORS_DE_JAVA = "(?!(java|javax|jdk|sun)\\.).*";

    /** Traduction des messages du système et de Java. */
    private static final String[][] PANNES = {{"No space left on device", "disque plein"},
        {"Aucun espace disponible sur le périphérique", "disque plein"},
        {"There is not enough space on the disk", "disque plein"}, {"Espace insuffisant sur le disque", "disque plein"},
        {"Disk quota exceeded", "quota de disque dépassé"}, {"File too large", "fichier trop grand"},
        {"File name too long", "nom de fichier trop long"}, {"Not a directory", "le dossier n'existe pas"},
        {"Read-only file system", "système de fichiers en lecture seule"}, {"Is a directory", "c'est un dossier"},
        {"Device or resource busy", "c'est un point de montage, que rien ne remplace"},
        {"Too many levels of symbolic links", "trop de liens symboliques"}, {"Broken pipe", "plus personne ne lit"},
        {"NoSuchFileException", "fichier introuvable"}, {"AccessDeniedException", "accès interdit"}};

    /** Catégories Unicode des caractères qui agissent sur le terminal, sont invisibles ou ressemblent à un blanc. */
    private static final int INVISIBLES = 1 << Character.CONTROL | 1 << Character.FORMAT | 1 << Character.SURROGATE
            | 1 << Character.SPACE_SEPARATOR | 1 << Character.LINE_SEPARATOR | 1 << Character.PARAGRAPH_SEPARATOR;

    private Texte() {
    }

    public static String minuscules(String mot) {
        return mot.toLowerCase(Locale.ROOT);
    }

    /** Le texte entre guillemets, caractères de contrôle échappés, coupé à 60 caractères. */
    public static String cite(String texte) {
        return "« " + abrege(texte) + " »";
    }

    /** Le texte, caractères de contrôle échappés, coupé à 60 caractères. */
    public static String abrege(String texte) {
        return echapper(texte, CITATION_MAX);
    }

    /** Le texte, caractères de contrôle échappés. */
    public static String echappe(String texte) {
        return echapper(texte, Integer.MAX_VALUE);
    }

    private static String echapper(String texte, int max) {
        StringBuilder s = new StringBuilder();
        int gardes = 0;
        for (int i = 0; i < texte.length(); i += Character.charCount(texte.codePointAt(i))) {
            echapper(texte.codePointAt(i), s);
            if (s.length() > max) {
                s.setLength(gardes);
                return s.append('…').toString();
            }
            if (s.length() < max) {
                gardes = s.length();
            }
        }
        return s.toString();
    }

    /** Explication, si la langue du système ne permet pas de lire ce chemin ou le dossier courant ; vide sinon. */
    public static String horsLangue(String chemin) {
        String codage = System.getProperty("sun.jnu.encoding", "UTF-8");
        return Charset.forName(codage).newEncoder().canEncode(chemin) && new File("").getAbsoluteFile().exists() ? ""
                : " (la langue du système, réglée sur " + codage
                        + ", ne permet pas de lire ce nom : mettre LC_ALL=C.UTF-8 devant la commande)";
    }

    /** La raison d'une erreur de fichier, en français si elle est connue ; sinon, son nom en Java. */
    public static String panne(IOException e) {
        String dit = e instanceof FileSystemException ? ((FileSystemException) e).getReason() : e.getMessage();
        String raison = dit == null ? e.getClass().getSimpleName() : dit;
        for (String[] connue : PANNES) {
            if (raison.startsWith(connue[0])) {
                return connue[1];
            }
        }
        return abrege(raison);
    }

    /** Cause d'un échec, et première ligne de sa pile dont la classe suit une de ces expressions, par préférence. */
    public static String cause(Throwable echec, String... classes) {
        Throwable cause = echec;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        String dit = echappe(cause.toString());
        StackTraceElement[] pile = cause.getStackTrace().length > 0 ? cause.getStackTrace() : echec.getStackTrace();
        for (String noms : classes) {
            for (StackTraceElement pas : pile) {
                if (pas.getClassName().matches(noms)) {
                    return dit + " (" + pas.getClassName() + "." + pas.getMethodName() + ", " + pas.getFileName() + ":"
                            + pas.getLineNumber() + ")";
                }
            }
        }
        return dit;
    }

    private static void echapper(int c, StringBuilder s) {
        int blanc = "\n\r\t".indexOf(c);
        if (blanc >= 0) {
            s.append('\\').append("nrt".charAt(blanc));
        } else if (c == ' ' || (1 << Character.getType(c) & INVISIBLES) == 0) {
            s.appendCodePoint(c);
        } else {
            for (char unite : Character.toChars(c)) {
                s.append("\\u").append(Integer.toHexString(0x10000 | unite), 1, 5);
            }
        }
    }
}
