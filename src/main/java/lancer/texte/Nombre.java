package lancer.texte;

import java.math.BigDecimal;
import java.util.Locale;

/**
 * L'écriture d'un nombre, dans les scènes comme en ligne de commande :
 * {@code [+-]?(chiffres[.chiffres] | chiffres. | .chiffres)([eE][+-]?chiffres)?}. {@link Double#parseDouble}
 * accepterait aussi « 1d », « 0x1p3 », « NaN » ou des blancs.
 */
public final class Nombre {

    private Nombre() {
    }

    /** Arrondit à cinq chiffres. Près de 1, l'écart à 1 garde cinq chiffres, car une puissance l'agrandit. */
    public static String arrondir(double x) {
        double manque = 1 - Math.abs(x);
        int chiffres = manque > 0 && manque < 0.1 ? 4 - (int) Math.floor(Math.log10(manque)) : 5;
        return x == 0 ? "0" : String.format(Locale.ROOT, "%." + chiffres + "g", x).replace("e-0", "e-");
    }

    /** Arrondit une composante de couleur à trois décimales ou, si elle est plus petite, à un chiffre. */
    public static String arrondirComposante(double x) {
        String format = Math.abs(x) >= 5e-4 ? "%.3f" : "%.0e";
        return x == 0 ? "0" : String.format(Locale.ROOT, format, x).replace("e-0", "e-");
    }

    /** Le nombre écrit ; infini s'il déborde, NaN si le texte n'est pas un nombre. */
    public static double lire(String s) {
        return lire(s, ".eE+-");
    }

    /** L'entier écrit, en chiffres seuls ; infini s'il déborde, NaN si le texte n'est pas un entier. */
    public static double lireEntier(String s) {
        return lire(s, "");
    }

    /** @param signes les caractères permis, outre les chiffres */
    private static double lire(String s, String signes) {
        for (int i = 0; i < s.length(); i++) {
            if ((s.charAt(i) < '0' || s.charAt(i) > '9') && signes.indexOf(s.charAt(i)) < 0) {
                return Double.NaN;
            }
        }
        try {
            return Double.parseDouble(s);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    /** L'écriture d'un nombre, sans « .0 » ni zéro inutile, avec un exposant hors de [1e-5, 1e7[ : 0, 0.05, 1e100. */
    public static String ecrire(double x) {
        boolean ordinaire = x == 0 || Math.abs(x) >= 1e-5 && Math.abs(x) < 1e7;
        return ordinaire ? new BigDecimal(Double.toString(x)).stripTrailingZeros().toPlainString()
                : Double.toString(x).replace(".0E", "e").replace('E', 'e');
    }

    /** L'écriture d'un nombre, pour être lu : 1/1024 pour l'inverse d'un entier, sauf d'une puissance de dix. */
    public static String enFraction(double x) {
        double inverse = 1 / x;
        boolean fraction = inverse >= 16 && inverse < 1e7 && inverse == Math.rint(inverse) && ecrire(x).length() > 6;
        return fraction ? "1/" + ecrire(inverse) : ecrire(x);
    }
}
