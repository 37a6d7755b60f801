package lancer.correction.jugement;

/** Une faute de compilation. */
public final class Faute {

    public final String fichier;
    public final int ligne;
    public final String message;

    Faute(String fichier, int ligne, String message) {
        this.fichier = fichier;
        this.ligne = ligne;
        this.message = Traduction.francais(message);
    }

    /** Le nom de la classe du fichier, sans son paquet. */
    public String classe() {
        return fichier.replaceFirst(".*/", "").replaceFirst("\\.java$", "");
    }

    @Override
    public String toString() {
        return fichier.replaceFirst(".*/", "") + ":" + ligne + " : " + message;
    }
}
