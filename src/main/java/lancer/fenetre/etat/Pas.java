package lancer.fenetre.etat;

import java.math.BigDecimal;
import lancer.texte.Nombre;

/** Un nombre d'un texte, changé d'un pas : une unité de son dernier chiffre écrit. */
public final class Pas {

    private Pas() {
    }

    /** Le texte où le nombre qui est à cette place a changé de tant de pas ; {@code null} si ce n'en est pas un. */
    public static String changer(String texte, int place, int pas) {
        int debut = Math.min(place, texte.length());
        while (debut > 0 && !Character.isWhitespace(texte.charAt(debut - 1))) {
            debut--;
        }
        int fin = debut;
        while (fin < texte.length() && !Character.isWhitespace(texte.charAt(fin))) {
            fin++;
        }
        String mot = texte.substring(debut, fin);
        if (!(Math.abs(Nombre.lire(mot)) < Double.POSITIVE_INFINITY)) {
            return null;
        }
        BigDecimal nombre = new BigDecimal(mot.endsWith(".") ? mot.substring(0, mot.length() - 1) : mot);
        BigDecimal voisin = nombre.add(nombre.ulp().multiply(BigDecimal.valueOf(pas)));
        String ecrit = mot.matches(".*[eE].*") ? voisin.toString() : voisin.toPlainString();
        return texte.substring(0, debut) + ecrit + texte.substring(fin);
    }
}
