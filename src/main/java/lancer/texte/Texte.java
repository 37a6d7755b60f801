package lancer.texte;

import java.util.Locale;

/** Prépare un texte d'un fichier ou de la ligne de commande pour un message d'une ligne. */
public final class Texte {

    /** Catégories Unicode des caractères qui agissent sur le terminal, sont invisibles ou ressemblent à un blanc. */
    private static final int INVISIBLES = 1 << Character.CONTROL | 1 << Character.FORMAT | 1 << Character.SURROGATE
            | 1 << Character.SPACE_SEPARATOR | 1 << Character.LINE_SEPARATOR | 1 << Character.PARAGRAPH_SEPARATOR;

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
        return echapper(texte, 60);
    }

    /** Le texte, caractères de contrôle échappés. */
    public static String echappe(String texte) {
        return echapper(texte, Integer.MAX_VALUE);
    }

    private static String echapper(String texte, int max) {
        StringBuilder s = new StringBuilder();
        int gardes = 0;
        for (int i = 0; i < texte.length(); i += Character.charCount(texte.codePointAt(i))) {
            echapper(texte.codePointAt(i), s);
            if (s.length() > max) {
                s.setLength(gardes);
                return s.append('…').toString();
            }
            if (s.length() < max) {
                gardes = s.length();
            }
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
