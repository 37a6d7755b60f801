package lancer.correction.jugement;

import java.text.MessageFormat;
import java.text.ParsePosition;
import java.util.List;
import lancer.correction.modele.SourcesDuCours;

/** Une faute de compilation. */
final class Faute {

    /** Messages ordinaires du compilateur d'Eclipse, chacun suivi de sa traduction ; les autres sont cités. */
    private static final String[] MESSAGES = SourcesDuCours.ressource("compilateur.txt")
            .replace("{java}", "" + Runtime.version().feature()).split(" = |\n");

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

    /** Dit si le code est juste dans une version plus récente de Java. */
    boolean demandeJava() {
        return message.startsWith("demande Java ");
    }

    @Override
    public String toString() {
        return fichier.replaceFirst(".*/", "") + ":" + ligne + " : " + message;
    }

    /** Traduit un message sans retour en arrière : il vient d'un rendu, et peut être long. */
    static String francais(String message) {
        String court = message.replace("lancer.", "").replace("java.lang.", "");
        for (int k = 0; k < MESSAGES.length; k += 2) {
            ParsePosition fin = new ParsePosition(0);
            Object[] pris = new MessageFormat(MESSAGES[k]).parse(court, fin);
            if (pris != null && fin.getIndex() == court.length()) {
                return MessageFormat.format(MESSAGES[k + 1], pris);
            }
        }
        return "le compilateur dit « " + court + " »";
    }
}
