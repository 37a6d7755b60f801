package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Les sommes que dit {@code --pixel}, refaites ligne par ligne. */
public final class Sommes {

    private static final String TRIPLET = "(\\S+ \\S+ \\S+)";
    private static final Pattern TERME = Pattern.compile("(?: {7}=| {5}autre terme =| {7}diffus \\+ reflet ne donne pas"
            + "| {7}Ks \\(.*\\) ⊗ (?:vue|somme) \\d+ (?:=|ne donne pas)) " + TRIPLET);
    private static final Pattern AUTRE = Pattern.compile(" {5}autre = " + TRIPLET + " \\(que le récit ne connaît pas\\)");
    private static final Pattern SOMME = Pattern.compile(" {3}somme \\d+ = " + TRIPLET);

    private Sommes() {
    }

    /**
     * Pour chaque contact de ce récit, ce qu'il dit ne pas connaître, {@code null} s'il connaît tout : alors ses termes, dans
     * l'ordre, donnent la somme au bit près ; sinon, non.
     */
    public static List<double[]> de(String recit) {
        List<double[]> autres = new ArrayList<>();
        double[] termes = new double[3];
        double[] autre = null;
        boolean surface = false;
        for (String ligne : recit.split("\\R")) {
            double[] terme = lire(TERME, ligne);
            double[] somme = lire(SOMME, ligne);
            surface |= ligne.startsWith("   N = ");
            if (terme != null) {
                Triplets.ajouter(termes, terme);
            } else if (lire(AUTRE, ligne) != null) {
                autre = lire(AUTRE, ligne);
            } else if (somme != null && surface) {
                autres.add(autre);
                if (autre == null) {
                    assertArrayEquals(somme, termes, recit);
                } else {
                    assertFalse(Arrays.equals(somme, termes), recit);
                    assertArrayEquals(Triplets.moins(somme, termes), autre, recit);
                }
            }
            // d'un reflet, la somme vient après ses termes, avant ceux de la suite
            if (somme != null) {
                termes = new double[3];
                autre = null;
                surface = false;
            }
        }
        return autres;
    }

    private static double[] lire(Pattern motif, String ligne) {
        Matcher m = motif.matcher(ligne);
        return m.matches() ? Arrays.stream(m.group(1).split(" ")).mapToDouble(Double::parseDouble).toArray() : null;
    }
}
