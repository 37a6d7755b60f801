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
    private static final Pattern TERME = Pattern.compile(" *(?:.* éclairée : diffus \\+ reflet"
            + "|Ks \\(.*\\) ⊗ (?:vue|somme) \\d+) = " + TRIPLET);
    private static final Pattern AUTRE = Pattern.compile(" {2}autre = " + TRIPLET + " \\(que le récit ne connaît pas\\)");
    private static final Pattern SOMME = Pattern.compile("\\d+  \\[.*  " + TRIPLET + "(?: = .*| : .*)");

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
        double[] somme = null;
        for (String ligne : (recit + "\n0  fin").split("\\R")) {
            double[] terme = lire(TERME, ligne);
            if (terme != null) {
                Triplets.ajouter(termes, terme);
            } else if (lire(AUTRE, ligne) != null) {
                autre = lire(AUTRE, ligne);
            } else if (ligne.matches("\\d+  .*")) {
                // le contact qui précède est fini
                if (somme != null) {
                    autres.add(autre);
                    verifier(somme, termes, autre, recit);
                }
                somme = lire(SOMME, ligne);
                termes = new double[3];
                autre = null;
            }
        }
        return autres;
    }

    private static void verifier(double[] somme, double[] termes, double[] autre, String recit) {
        if (autre == null) {
            assertArrayEquals(somme, termes, recit);
        } else {
            assertFalse(Arrays.equals(somme, termes), recit);
            assertArrayEquals(Triplets.moins(somme, termes), autre, recit);
        }
    }

    private static double[] lire(Pattern motif, String ligne) {
        Matcher m = motif.matcher(ligne);
        return m.matches() ? Arrays.stream(m.group(1).split(" ")).mapToDouble(Double::parseDouble).toArray() : null;
    }
}
