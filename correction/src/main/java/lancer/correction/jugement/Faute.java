package lancer.correction.jugement;

import java.io.Serializable;

/** Une faute de compilation. */
public final class Faute implements Serializable {

    private static final long serialVersionUID = 1;

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
