package lancer.correction.jugement;

import java.util.List;

/** Une faute de compilation. */
final class Faute {

    final String fichier;
    final int ligne;
    final String message;

    /** @param dite son fichier, sa ligne, son message */
    Faute(List<?> dite) {
        fichier = (String) dite.get(0);
        ligne = (Integer) dite.get(1);
        message = Traduction.francais((String) dite.get(2));
    }

    /** Le nom de la classe du fichier, sans son paquet. */
    String classe() {
        return fichier.replaceFirst(".*/", "").replaceFirst("\\.java$", "");
    }

    @Override
    public String toString() {
        return fichier.replaceFirst(".*/", "") + ":" + ligne + " : " + message;
    }
}
