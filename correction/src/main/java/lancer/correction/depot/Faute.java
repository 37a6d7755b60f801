package lancer.correction.depot;

/** Une faute de compilation : son fichier, sa ligne, et ce que dit le compilateur. */
public final class Faute {

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

    /** Ce message, cité. */
    public static String citer(String message) {
        return "le compilateur dit « " + message + " »";
    }
}
