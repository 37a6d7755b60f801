package lancer.correction.enfant;

import java.util.List;
import java.util.regex.Pattern;

/** Un texte qui vient d'un rendu, tel qu'un terminal, une page ou un tableur peut le montrer. */
public final class Texte {

    /** Caractères qui commandent un terminal ou changent le sens d'écriture, moitiés de caractères ; ni tabulation, ni fin de ligne. */
    public static final Pattern NUISIBLES = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Cs}\\p{Zl}\\p{Zp}&&[^\n\t]]");

    private static final Pattern BLANCS = Pattern.compile("\\s+");
    private static final int TEXTE_MAX = 2000;
    private static final int LIGNES_MAX = 30;

    private Texte() {
    }

    /** Un texte sans caractère nuisible, en une ligne de longueur limitée. */
    public static String protege(String texte) {
        return protege(texte, TEXTE_MAX);
    }

    /** Le même, d'au plus {@code max} caractères, puis « … » s'il est coupé. */
    public static String protege(String texte, int max) {
        String court = texte.length() > max ? couper(texte, max) + "…" : texte;
        return BLANCS.matcher(NUISIBLES.matcher(court).replaceAll(" ")).replaceAll(" ").trim();
    }

    /** Protège un texte qu'un tableur prendrait pour une formule, en tête ou après « ; », qui peut séparer les cases. */
    public static String sansFormule(String texte) {
        return protege(texte, Integer.MAX_VALUE).replaceAll("(^|;)([\\s\"']*)(?=[=+@-])", "$1$2'");
    }

    /** Le début d'un texte, d'au plus {@code max} caractères ; aucun n'est coupé en deux. */
    public static String couper(String texte, int max) {
        if (texte.length() <= max) {
            return texte;
        }
        return texte.substring(0, Character.isHighSurrogate(texte.charAt(max - 1)) ? max - 1 : max);
    }

    /** « 1 entrée », « 2 entrées ». */
    public static String compter(long nombre, String nom) {
        return nombre + " " + nom + (nombre > 1 ? "s" : "");
    }

    /** Limite une liste à quelques lignes de longueur limitée, pour une page. */
    public static void abreger(List<String> liste) {
        liste.replaceAll(Texte::protege);
        if (liste.size() > LIGNES_MAX) {
            liste.subList(LIGNES_MAX, liste.size()).clear();
            liste.add("…");
        }
    }
}
