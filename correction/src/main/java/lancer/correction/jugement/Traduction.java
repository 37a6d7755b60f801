package lancer.correction.jugement;

/** Les dix messages les plus ordinaires du compilateur d'Eclipse, en français ; les autres sont cités. */
final class Traduction {

    /** Chaque « * » est n'importe quel texte, que « 1 », puis « 2 », reprennent. */
    private static final String[][] MESSAGES = {
        {"* cannot be resolved to a type", "le type 1 est inconnu"},
        {"* cannot be resolved to a variable", "la variable 1 est inconnue"},
        {"The import * cannot be resolved", "import inconnu : 1"},
        {"* cannot be resolved", "1 est inconnu"},
        {"The method * is undefined for the type *", "la méthode 1 n'existe pas dans 2"},
        {"The method * in the type * is not applicable for the arguments *",
        "la méthode 1 de 2 ne prend pas les arguments 3"},
        {"Syntax error, insert \"*\" to complete *", "syntaxe : il manque « 1 »"},
        {"Syntax error on token*", "syntaxe incorrecte ici"},
        {"Type mismatch: cannot convert from * to *", "un 1 ne peut devenir un 2"},
        {"This method must return a result of type *", "cette méthode doit retourner un 1"},
    };

    private Traduction() {
    }

    static String francais(String message) {
        String court = message.replace("lancer.", "").replace("java.lang.", "");
        for (String[] paire : MESSAGES) {
            String traduit = traduire(court, paire[0].split("\\*", -1), paire[1]);
            if (traduit != null) {
                return traduit;
            }
        }
        return "le compilateur dit « " + court + " »";
    }

    /** Cherche les morceaux l'un après l'autre, sans jamais revenir : ce message vient d'un rendu, qui peut être long. */
    private static String traduire(String message, String[] morceaux, String modele) {
        if (!message.startsWith(morceaux[0])) {
            return null;
        }
        String[] pris = new String[morceaux.length];
        int debut = morceaux[0].length();
        for (int k = 1; k < morceaux.length; k++) {
            int fin = morceaux[k].isEmpty() ? message.length() : message.indexOf(morceaux[k], debut);
            if (fin < debut || k == morceaux.length - 1 && fin + morceaux[k].length() < message.length()) {
                return null;
            }
            pris[k] = message.substring(debut, fin);
            debut = fin + morceaux[k].length();
        }
        StringBuilder traduit = new StringBuilder();
        modele.chars().forEach(c -> traduit.append(c > '0' && c <= '9' ? pris[c - '0'] : "" + (char) c));
        return traduit.toString();
    }
}
