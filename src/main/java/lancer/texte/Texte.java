package lancer.texte;

import java.util.Locale;

/** Prépare un texte d'un fichier ou de la ligne de commande pour un message d'une ligne. */
public final class Texte {

    /** Catégories Unicode des caractères qui agissent sur le terminal, sont invisibles ou ressemblent à un blanc. */
    private static final int INVISIBLES = 1 << Character.CONTROL | 1 << Character.FORMAT | 1 << Character.SURROGATE
            | 1 << Character.SPACE_SEPARATOR | 1 << Character.LINE_SEPARATOR | 1 << Character.PARAGRAPH_SEPARATOR;

    /** Longueur d'une citation, en caractères. */
    private static final int LONGUEUR = 60;

    private Texte() {
    }

    public static String minuscules(String mot) {
        return mot.toLowerCase(Locale.ROOT);
    }

    /** {@link #abrege}, entre guillemets. */
    public static String cite(String texte) {
        return "« " + abrege(texte) + " »";
    }

    /** Le texte, caractères de contrôle échappés, coupé à 60 caractères. */
    public static String abrege(String texte) {
        // la suite d'un long texte serait échappée en vain
        String echappe = echappe(texte.substring(0, Math.min(texte.length(), LONGUEUR + 1)));
        // la première moitié d'un caractère en deux unités n'est pas gardée seule
        return echappe.length() <= LONGUEUR ? echappe
                : echappe.substring(0, LONGUEUR - 1).replaceFirst("[\ud800-\udbff]$", "") + '…';
    }

    /** Le texte, caractères de contrôle échappés. */
    public static String echappe(String texte) {
        StringBuilder s = new StringBuilder();
        for (int i = 0; i < texte.length(); i += Character.charCount(texte.codePointAt(i))) {
            echapper(texte.codePointAt(i), s);
        }
        return s.toString();
    }

    private static void echapper(int c, StringBuilder s) {
        int blanc = "\n\r\t".indexOf(c);
        if (blanc >= 0) {
            s.append('\\').append("nrt".charAt(blanc));
        } else if (c == ' ' || (1 << Character.getType(c) & INVISIBLES) == 0) {
            s.appendCodePoint(c);
        } else {
            for (char unite : Character.toChars(c)) {
                s.append("\\u").append(Integer.toHexString(0x10000 | unite), 1, 5);
            }
        }
    }
}
