package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;

/** Une rangée de {@code rangees.txt} : ce que son test vient de mesurer, par la formule naïve, par la nôtre, et en vérité. */
public final class Rangee {

    private Rangee() {
    }

    /**
     * Vérifie que la table donne ces trois nombres.
     *
     * @param test celui qui mesure, tel que la table le nomme
     */
    public static void montre(String test, double naif, double notre, double vrai) {
        String cellules = " | " + DoubleStream.of(naif, notre, vrai).mapToObj(Rangee::nombre).collect(Collectors.joining(" | ")) + " | ";
        try (BufferedReader table = new BufferedReader(new InputStreamReader(Ressources.ouvrir("rangees.txt"), StandardCharsets.UTF_8))) {
            assertTrue(table.lines().anyMatch(l -> l.contains("." + test + "`") && l.contains(cellules)),
                    "rangees.txt ne donne plus ce que mesure " + test + " : " + cellules);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Un nombre à deux chiffres, à la française. */
    private static String nombre(double x) {
        return Double.isNaN(x) ? "NaN" : Double.isInfinite(x) ? "∞" : x == Math.rint(x) && Math.abs(x) < 1e6 ? String.valueOf((long) x)
                : (Math.abs(x) >= 1e-3 && Math.abs(x) < 1e6 ? String.format(Locale.FRANCE, "%.2g", x)
                : String.format(Locale.FRANCE, "%.0e", x)).replaceFirst("e([-+])0", "e$1").replace("e+", "e");
    }
}
