package lancer.correction.depot;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Une faute de compilation : son fichier, sa ligne, et ce que dit le compilateur. */
public final class Faute {

    private static final Pattern ABSENTE = Pattern.compile("The method .* is undefined for the type (?:\\w+\\.)*(\\w+)\\b.*");

    public final String fichier;
    public final int ligne;
    public final String message;

    public Faute(String fichier, int ligne, String message) {
        this.fichier = fichier;
        this.ligne = ligne;
        this.message = message;
    }

    /** Le nom de la classe du fichier, sans son paquet. */
    public String classe() {
        return fichier.replaceFirst(".*/", "").replaceFirst("\\.java$", "");
    }

    @Override
    public String toString() {
        return fichier.replaceFirst(".*/", "") + ":" + ligne + " : " + citer(message);
    }

    /** Ce message, cité ; et, s'il y manque une méthode de Java, la version de Java de la correction. */
    public static String citer(String message) {
        Matcher absente = ABSENTE.matcher(message);
        return "le compilateur dit « " + message + " »" + (absente.matches() && estDeJava(absente.group(1)) ? " ; Java "
                + Runtime.version().feature() + ", celui de la correction, n'a pas cette méthode, qu'un Java plus récent a peut-être" : "");
    }

    private static boolean estDeJava(String classe) {
        return Stream.of("java.lang.", "java.util.", "java.util.stream.")
                .anyMatch(paquet -> ClassLoader.getPlatformClassLoader().getResource((paquet + classe).replace('.', '/') + ".class") != null);
    }
}
