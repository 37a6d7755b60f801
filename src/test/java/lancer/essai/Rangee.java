package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;

/** Une rangée de {@code docs/stabilite-cas.md} : ce que son test vient de mesurer, par la formule naïve, par la nôtre, et en vérité. */
public final class Rangee {

    private Rangee() {
    }

    /**
     * Vérifie que la page montre ces trois nombres.
     *
     * @param test celui qui mesure, tel que la page le nomme
     */
    public static void montre(String test, double naif, double notre, double vrai) {
        String cellules = "| " + DoubleStream.of(naif, notre, vrai).mapToObj(Rangee::nombre).collect(Collectors.joining(" | ")) + " | ";
        Path page = Paths.get(Files.exists(Paths.get("docs")) ? "docs" : "../docs", "stabilite-cas.md");
        try {
            assertTrue(Files.readAllLines(page).stream().anyMatch(l -> l.contains("." + test + "`") && l.contains(cellules)),
                    page + " ne montre plus ce que mesure " + test + " : " + cellules);
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
