package lancer.correction.depot;

/** Une faute de compilation : son fichier, sa ligne, et ce que dit le compilateur. */
public final class Faute {

    private static final String ABSENTE = "The method .* is undefined for the type (java\\.|(Math|String|List|Arrays|Stream)\\b).*";

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
        return "le compilateur dit « " + message + " »" + (!message.matches(ABSENTE) ? "" : " ; Java " + Runtime.version().feature()
                + ", celui de la correction, n'a pas cette méthode, qu'un Java plus récent a peut-être");
    }
}
