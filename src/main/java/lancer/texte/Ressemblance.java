package lancer.texte;

import java.lang.Character.UnicodeScript;
import java.text.Normalizer;

/** Les caractères que l'on prend pour d'autres, comme le signe moins pour un trait d'union. */
public final class Ressemblance {

    /** Des lettres cyrilliques et grecques, et un signe, qui ont le dessin d'une lettre latine (Unicode, UTS 39). */
    private static final String TROMPEURS = "\u0430\u0435\u0456\u0458\u043e\u0440\u0441\u0455\u0443\u0445\u043a\u04bb"
            + "\u0410\u0412\u0415\u041d\u0406\u0408\u041a\u041c\u041e\u0420\u0421\u0405\u0422\u0425"
            + "\u03bf\u03bd\u0391\u0392\u0395\u0397\u0399\u039a\u039c\u039d\u039f\u03a1\u03a4\u03a7\u00d7";
    private static final String LATINS = "aeijopcsyxkhABEHIJKMOPCSTXovABEHIKMNOPTXx";

    private Ressemblance() {
    }

    /** Le premier caractère de ce texte que l'on prend pour un autre, entre parenthèses ; vide s'il n'y en a pas. */
    public static String dire(String texte) {
        return texte.codePoints().filter(c -> !ordinaire(c).isEmpty()).mapToObj(c -> " (" + nom(c)
                + String.format(" U+%04X, au lieu de ", c) + ordinaire(c) + ")").findFirst().orElse("");
    }

    /** Le caractère ASCII auquel celui-ci ressemble ; vide s'il n'est pas trompeur. */
    private static String ordinaire(int c) {
        if (c < 0x80 || Character.isSpaceChar(c)) {
            return "";
        }
        if (estUnTiret(c)) {
            return "-";
        }
        int rang = TROMPEURS.indexOf(c);
        if (rang >= 0) {
            return LATINS.substring(rang, rang + 1);
        }
        if (Character.isDigit(c)) {
            return String.valueOf(Character.digit(c, 10));
        }
        // pleine chasse, gras mathématique, exposant : Unicode les dit équivalents
        String equivalent = Normalizer.normalize(new String(Character.toChars(c)), Normalizer.Form.NFKC);
        return equivalent.length() == 1 && equivalent.charAt(0) < 0x80 ? equivalent : "";
    }

    private static boolean estUnTiret(int c) {
        return c == 0x2212 || Character.getType(c) == Character.DASH_PUNCTUATION;
    }

    private static String nom(int c) {
        if (c == 0x2212) {
            return "le signe moins";
        }
        if (estUnTiret(c)) {
            return "le tiret";
        }
        if (Character.isDigit(c)) {
            return "le chiffre";
        }
        UnicodeScript ecriture = UnicodeScript.of(c);
        if (ecriture == UnicodeScript.CYRILLIC) {
            return "la lettre cyrillique";
        }
        return ecriture == UnicodeScript.GREEK ? "la lettre grecque" : "le caractère";
    }
}
