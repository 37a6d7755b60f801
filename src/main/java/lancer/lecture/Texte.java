package lancer.lecture;

/** Un texte venu d'ailleurs (fichier, ligne de commande), rendu montrable dans un message d'une ligne. */
public final class Texte {

    /** Longueur au-delà de laquelle une citation est coupée, en caractères. */
    public static final int CITATION_MAX = 60;

    private Texte() {
    }

    /**
     * Vrai si deux mots ne diffèrent que par la casse. Une lettre ASCII n'y est égale qu'à elle-même, grande ou
     * petite, au contraire de {@link String#equalsIgnoreCase} pour qui le signe du kelvin est un k.
     */
    static boolean memeMot(String a, String b) {
        if (a.length() != b.length()) {
            return false;
        }
        for (int i = 0; i < a.length(); i++) {
            if (minuscule(a.charAt(i)) != minuscule(b.charAt(i))) {
                return false;
            }
        }
        return true;
    }

    /** Le mot tel que tous ceux que {@link #memeMot} dit égaux le donnent. */
    static String minuscules(String mot) {
        char[] lettres = mot.toCharArray();
        for (int i = 0; i < lettres.length; i++) {
            lettres[i] = minuscule(lettres[i]);
        }
        return new String(lettres);
    }

    private static char minuscule(char c) {
        char minuscule = Character.toLowerCase(c);
        return minuscule < 128 && c >= 128 ? c : minuscule;
    }

    /** Le texte entre guillemets, caractères de contrôle échappés, coupé à 60 caractères. */
    public static String cite(String texte) {
        return "« " + abrege(texte) + " »";
    }

    /** Le texte sans caractère de contrôle, coupé à 60 caractères. */
    public static String abrege(String texte) {
        StringBuilder s = new StringBuilder();
        int gardes = 0;
        for (int i = 0; i < texte.length(); i += Character.charCount(texte.codePointAt(i))) {
            echapper(texte.codePointAt(i), s);
            if (s.length() > CITATION_MAX) {
                s.setLength(gardes);
                return s.append('…').toString();
            }
            if (s.length() < CITATION_MAX) {
                gardes = s.length();
            }
        }
        return s.toString();
    }

    /** Le texte, chaque caractère qui casserait ou brouillerait la ligne remplacé par son code. */
    public static String echappe(String texte) {
        StringBuilder s = new StringBuilder();
        for (int i = 0; i < texte.length(); i += Character.charCount(texte.codePointAt(i))) {
            echapper(texte.codePointAt(i), s);
        }
        return s.toString();
    }

    private static void echapper(int c, StringBuilder s) {
        if (c == '\n') {
            s.append("\\n");
        } else if (c == '\r') {
            s.append("\\r");
        } else if (c == '\t') {
            s.append("\\t");
        } else if (c == ' ' || visible(Character.getType(c))) {
            s.appendCodePoint(c);
        } else {
            for (char unite : Character.toChars(c)) {
                s.append("\\u").append(Integer.toHexString(0x10000 | unite), 1, 5);
            }
        }
    }

    /** Faux pour ce qui agit sur le terminal, ne se voit pas, ou ressemble à un blanc sans en être un. */
    private static boolean visible(int type) {
        return type != Character.CONTROL && type != Character.FORMAT && type != Character.SURROGATE
                && type != Character.SPACE_SEPARATOR && type != Character.LINE_SEPARATOR
                && type != Character.PARAGRAPH_SEPARATOR;
    }
}
