package lancer.texte;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Prépare un texte d'un fichier ou de la ligne de commande pour un message d'une ligne. */
public final class Texte {

    /** Caractères qui agissent sur le terminal, sont invisibles ou ressemblent à un blanc. */
    private static final Pattern INVISIBLES = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Cs}\\p{Z}&&[^ ]]+");

    /** Longueur d'une citation, en caractères. */
    private static final int LONGUEUR = 60;

    /** La première moitié d'un caractère que la coupure d'une citation n'a pas laissé entier. */
    private static final String MOITIE = "[\ud800-\udbff]$";

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
        return echappe.length() <= LONGUEUR ? echappe
                : echappe.substring(0, LONGUEUR - 1).replaceFirst(MOITIE, "") + '…';
    }

    /** Le texte, caractères de contrôle échappés. */
    public static String echappe(String texte) {
        return echappe(texte, INVISIBLES);
    }

    /** Le texte, où ces caractères sont échappés. */
    public static String echappe(String texte, Pattern caracteres) {
        Matcher suite = caracteres.matcher(texte);
        StringBuffer echappe = new StringBuffer();
        while (suite.find()) {
            suite.appendReplacement(echappe, "");
            for (char c : suite.group().toCharArray()) {
                int blanc = "\n\r\t".indexOf(c);
                if (blanc >= 0) {
                    echappe.append('\\').append("nrt".charAt(blanc));
                } else {
                    echappe.append("\\u").append(Integer.toHexString(0x10000 | c), 1, 5);
                }
            }
        }
        return suite.appendTail(echappe).toString();
    }
}
