package lancer.correction.depot;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;

/** Une faute de compilation : son fichier, sa ligne, et ce que dit le compilateur. */
public final class Faute {

    /** Ce que dit le compilateur, et ce qu'il faut en savoir : son premier groupe est cité, puis la version de Java qui juge. */
    private static final Map<Pattern, String> REMEDES = new LinkedHashMap<>();

    static {
        REMEDES.put(Pattern.compile("^Syntax error, insert \"(\\W)\""),
                "il manque « %s »");
        REMEDES.put(Pattern.compile("only available with source level (\\d+)"), "il faut Java %s, et ici juge Java %s");
        REMEDES.put(Pattern.compile("^('_') is a keyword"), "il faut Java 22 pour nommer %s ce qui ne sert pas, et ici juge Java %s");
        REMEDES.put(Pattern.compile("^The method (\\w+)\\(.*\\) is undefined for the type "
                + "(?:java\\.|(?:Math|String|List|Arrays|Stream)\\b)"),
                "%s n'est pas dans Java %s, qui juge ici : est-elle d'une version plus récente ?");
    }

    public final String fichier;
    public final int ligne;
    public final String message;
    /** Ce que c'est, en français ; vide si seul le compilateur le dit. */
    public final String remede;

    public Faute(String fichier, int ligne, String message) {
        this.fichier = fichier;
        this.ligne = ligne;
        this.message = message;
        remede = REMEDES.entrySet().stream().flatMap(r -> r.getKey().matcher(message).results()
                .map(trouve -> String.format(r.getValue(), trouve.group(1), Runtime.version().feature()))).findFirst().orElse("");
    }

    /** Le nom de la classe du fichier, sans son paquet. */
    public String classe() {
        return fichier.replaceFirst(".*/", "").replaceFirst("\\.java$", "");
    }

    @Override
    public String toString() {
        return fichier.replaceFirst(".*/", "") + ":" + ligne + " : " + (remede.isEmpty() ? "" : remede + " ; ") + citer(message);
    }

    /** Ce message, cité. */
    public static String citer(String message) {
        return "le compilateur dit « " + message + " »";
    }
}
