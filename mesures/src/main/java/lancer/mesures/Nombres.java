package lancer.mesures;

import java.math.RoundingMode;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/** Les nombres des pages et des figures, à la française : une virgule, et une espace insécable entre les milliers. */
public final class Nombres {

    private Nombres() {
    }

    /** Un nombre de trois chiffres significatifs au plus sous mille. */
    public static String nombre(double valeur) {
        return chiffres(valeur, 3);
    }

    /** Un nombre de deux chiffres significatifs sous cent. */
    public static String arrondi(double valeur) {
        return chiffres(valeur, 2);
    }

    /** L'erreur d'une image : « 0,29 niveau ». Le pluriel est celui du nombre écrit : 1,98 s'écrit « 2 niveaux ». */
    public static String niveaux(double erreur) {
        return arrondi(erreur) + (erreur < 1.95 ? " niveau" : " niveaux");
    }

    /** Un nombre d'un fichier CSV, à cinq chiffres significatifs ; vide s'il manque. */
    public static String champ(double valeur) {
        return Double.isNaN(valeur) || Double.isInfinite(valeur) ? "" : String.format(Locale.ROOT, "%.5g", valeur);
    }

    /** Ce nombre d'un fichier CSV ; NaN s'il est vide. */
    public static double champ(String texte) {
        return texte.isEmpty() ? Double.NaN : Double.parseDouble(texte);
    }

    /** Les chiffres à écrire, sans en ôter avant la virgule. */
    private static String chiffres(double valeur, int combien) {
        int entiers = valeur == 0 ? 1 : (int) Math.floor(Math.log10(Math.abs(valeur)) + 1e-9) + 1;
        return format(Math.max(0, combien - entiers)).format(valeur);
    }

    /** L'écriture d'un nombre de tant de décimales au plus. */
    public static DecimalFormat format(int decimales) {
        DecimalFormatSymbols symboles = new DecimalFormatSymbols(Locale.ROOT);
        symboles.setDecimalSeparator(',');
        symboles.setGroupingSeparator('\u00A0');
        symboles.setMinusSign('\u2212');
        DecimalFormat format = new DecimalFormat("#,##0", symboles);
        format.setMaximumFractionDigits(decimales);
        format.setRoundingMode(RoundingMode.HALF_UP);
        return format;
    }
}
