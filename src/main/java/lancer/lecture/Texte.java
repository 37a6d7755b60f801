package lancer.lecture;

/** Un texte venu d'ailleurs (fichier, ligne de commande), rendu montrable dans un message d'une ligne. */
public final class Texte {

    /** Longueur au-delà de laquelle une citation est coupée, en caractères. */
    public static final int CITATION_MAX = 60;

    private Texte() {
    }

    /** Le texte entre guillemets, caractères de contrôle échappés, coupé à 60 caractères. */
    public static String cite(String texte) {
        return "« " + abrege(texte) + " »";
    }

    /** Le texte sans caractère de contrôle, coupé à 60 caractères. */
    public static String abrege(String texte) {
        if (texte.length() <= CITATION_MAX) {
            return echappe(texte);
        }
        // ne pas couper un caractère codé sur deux char
        int fin = Character.isHighSurrogate(texte.charAt(CITATION_MAX - 2)) ? CITATION_MAX - 2 : CITATION_MAX - 1;
        return echappe(texte.substring(0, fin)) + "…";
    }

    /** Le texte, chaque caractère qui casserait ou brouillerait la ligne remplacé par son code. */
    public static String echappe(String texte) {
        StringBuilder s = new StringBuilder();
        for (int i = 0; i < texte.length(); i++) {
            char c = texte.charAt(i);
            int type = Character.getType(c);
            if (c == '\n') {
                s.append("\\n");
            } else if (c == '\r') {
                s.append("\\r");
            } else if (c == '\t') {
                s.append("\\t");
            } else if (type == Character.CONTROL || type == Character.FORMAT || type == Character.LINE_SEPARATOR
                    || type == Character.PARAGRAPH_SEPARATOR) {
                s.append("\\u").append(Integer.toHexString(0x10000 | c), 1, 5);
            } else {
                s.append(c);
            }
        }
        return s.toString();
    }
}
