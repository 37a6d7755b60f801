package lancer.correction.jugement;

import java.text.MessageFormat;
import java.text.ParsePosition;
import java.util.List;

/** Une faute de compilation. */
final class Faute {

    private static final String DEMANDE = "demande Java ";

    /** Les messages les plus ordinaires du compilateur d'Eclipse, en français ; les autres sont cités. */
    private static final String[][] MESSAGES = {
        {"The Java feature ''{0}'' is only available with source level {1} and above", DEMANDE + "{1} ({0}), ici Java "
            + Runtime.version().feature()},
        {"''_'' is a keyword from source level 9 onwards, cannot be used as identifier", DEMANDE + "22 (variable sans nom), ici Java "
            + Runtime.version().feature()},
        {"{0} cannot be resolved to a type", "le type {0} est inconnu"},
        {"{0} cannot be resolved to a variable", "la variable {0} est inconnue"},
        {"The import {0} cannot be resolved", "import inconnu : {0}"},
        {"{0} cannot be resolved", "{0} est inconnu"},
        {"The method {0} is undefined for the type {1}", "la méthode {0} n''existe pas dans {1}"},
        {"The method {0} in the type {1} is not applicable for the arguments {2}",
            "la méthode {0} de {1} ne prend pas les arguments {2}"},
        {"Syntax error, insert \"{0}\" to complete {1}", "syntaxe : il manque « {0} »"},
        {"Syntax error on token \"{0}\", delete this token", "syntaxe : « {0} » est de trop"},
        {"Syntax error on token{0}", "syntaxe incorrecte ici"},
        {"Type mismatch: cannot convert from {0} to {1}", "un {0} ne peut devenir un {1}"},
        {"This method must return a result of type {0}", "cette méthode doit retourner un {0}"},
    };

    final String fichier;
    final int ligne;
    final String message;

    /** @param dite son fichier, sa ligne, son message */
    Faute(List<?> dite) {
        fichier = (String) dite.get(0);
        ligne = (Integer) dite.get(1);
        message = francais((String) dite.get(2));
    }

    /** Le nom de la classe du fichier, sans son paquet. */
    String classe() {
        return fichier.replaceFirst(".*/", "").replaceFirst("\\.java$", "");
    }

    /** Vrai si elle n'en est pas une pour une version de Java plus récente. */
    boolean demandeJava() {
        return message.startsWith(DEMANDE);
    }

    @Override
    public String toString() {
        return fichier.replaceFirst(".*/", "") + ":" + ligne + " : " + message;
    }

    /** Lit le message d'un bout à l'autre, sans jamais revenir : il vient d'un rendu, et peut être long. */
    static String francais(String message) {
        String court = message.replace("lancer.", "").replace("java.lang.", "");
        for (String[] paire : MESSAGES) {
            ParsePosition fin = new ParsePosition(0);
            Object[] pris = new MessageFormat(paire[0]).parse(court, fin);
            if (pris != null && fin.getIndex() == court.length()) {
                return MessageFormat.format(paire[1], pris);
            }
        }
        return "le compilateur dit « " + court + " »";
    }
}
