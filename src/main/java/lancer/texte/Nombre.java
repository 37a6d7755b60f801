package lancer.texte;

/**
 * L'écriture d'un nombre, dans les scènes comme en ligne de commande :
 * {@code [+-]?(chiffres[.chiffres] | chiffres. | .chiffres)([eE][+-]?chiffres)?}, et rien d'autre :
 * {@link Double#parseDouble} accepterait aussi « 1d », « 0x1p3 », « NaN » ou des blancs.
 */
public final class Nombre {

    /** Puissances de dix : chacune se représente exactement, comme un entier de quinze chiffres. */
    private static final double[] DIX =
            {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

    private Nombre() {
    }

    /**
     * Le nombre écrit, infini s'il déborde, NaN si ce n'en est pas un. Un entier court divisé par une puissance de dix
     * exacte est déjà l'arrondi juste (Clinger, 1990) : c'est le cas de presque tous, et des millions à lire.
     */
    public static double lire(String s) {
        int fin = s.length();
        boolean negatif = s.startsWith("-");
        int i = negatif || s.startsWith("+") ? 1 : 0;
        long mantisse = 0;
        int chiffres = 0;
        int decimales = 0;
        boolean virgule = false;
        for (; i < fin; i++) {
            char c = s.charAt(i);
            if (c >= '0' && c <= '9') {
                // au-delà de quinze chiffres elle déborde peut-être, et ne sert plus
                mantisse = 10 * mantisse + (c - '0');
                chiffres++;
                decimales += virgule ? 1 : 0;
            } else if (c == '.' && !virgule) {
                virgule = true;
            } else {
                break;
            }
        }
        if (chiffres == 0) {
            return Double.NaN;
        }
        if (i == fin && chiffres < DIX.length) {
            double valeur = mantisse / DIX[decimales];
            return negatif ? -valeur : valeur;
        }
        if (i < fin && !s.substring(i).matches("[eE][+-]?[0-9]+")) {
            return Double.NaN;
        }
        return Double.parseDouble(s);
    }

    /** Le nombre tel qu'on l'écrit à la main, sans « .0 » ni zéro inutile : 0, 0.05, 1e100. */
    public static String ecrire(double x) {
        String s = x == Math.rint(x) && Math.abs(x) < 1e7 ? Long.toString((long) x) : Double.toString(x);
        return s.replace(".0E", "e").replace('E', 'e');
    }
}
