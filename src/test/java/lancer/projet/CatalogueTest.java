package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** {@code docs/stabilite-cas.md} ne nomme que des tests qui existent, et n'oublie aucune des façons de se tromper. */
class CatalogueTest {

    private static final int FACONS = 50;
    private static final Path PAGE = Paths.get("docs", "stabilite-cas.md");
    private static final Path COURBES = Paths.get("docs", "stabilite.md");
    private static final Pattern ESSAI = Pattern.compile("`(\\w*Tests?)\\.(\\w+)`");
    private static final Pattern RANGEE = Pattern.compile("(?m)^\\| (\\d+) \\|.*$");
    private static final Pattern LIEN = Pattern.compile("\\]\\(([^)#:]+)\\)");

    private static String lire(Path fichier) throws IOException {
        return new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
    }

    /** Les sources de test de la base et des variantes, par nom de classe ; deux modules peuvent avoir le même. */
    private static Map<String, List<String>> sources() throws IOException {
        Map<String, List<String>> sources = new HashMap<>();
        for (String module : new String[] {".", "brume", "antialias", "blinn"}) {
            try (Stream<Path> fichiers = Files.walk(Paths.get(module, "src", "test", "java"))) {
                for (Path fichier : (Iterable<Path>) fichiers.filter(f -> f.toString().endsWith(".java"))::iterator) {
                    String nom = fichier.getFileName().toString().replace(".java", "");
                    sources.computeIfAbsent(nom, n -> new ArrayList<>()).add(lire(fichier));
                }
            }
        }
        return sources;
    }

    /** Vrai si cette source a une méthode de ce nom, que JUnit lance. */
    private static boolean aLEssai(String source, String methode) {
        int place = source.indexOf(" void " + methode + "(");
        if (place < 0) {
            return false;
        }
        // de la fin de la méthode d'avant jusqu'ici
        String avant = source.substring(Math.max(0, source.lastIndexOf(" void ", place - 1)), place);
        return avant.contains("@Test") || avant.contains("@ParameterizedTest");
    }

    @Test
    void chaqueTestNommeDansLaPageExiste() throws IOException {
        Map<String, List<String>> sources = sources();
        List<String> absents = new ArrayList<>();
        int nommes = 0;
        Matcher m = ESSAI.matcher(lire(PAGE));
        while (m.find()) {
            String methode = m.group(2);
            if (sources.getOrDefault(m.group(1), new ArrayList<>()).stream().noneMatch(s -> aLEssai(s, methode))) {
                absents.add(m.group());
            }
            nommes++;
        }
        assertEquals(new ArrayList<>(), absents);
        assertTrue(nommes > 2 * FACONS, nommes + " tests nommés");
    }

    @Test
    void chaqueFaconDeSeTromperASonTestOuUnePhraseQuiDitPourquoiElleNePeutPasArriver() throws IOException {
        Matcher m = RANGEE.matcher(lire(PAGE));
        int derniere = 0;
        while (m.find()) {
            assertEquals(++derniere, Integer.parseInt(m.group(1)), "l'ordre des rangées");
            assertTrue(ESSAI.matcher(m.group()).find() || m.group().contains("Ne peut pas arriver"), m.group());
        }
        assertEquals(FACONS, derniere);
    }

    @Test
    void chaqueLienDesDeuxPagesMeneAUnFichier() throws IOException {
        Matcher m = LIEN.matcher(lire(COURBES) + lire(PAGE));
        int liens = 0;
        while (m.find()) {
            assertTrue(Files.exists(PAGE.resolveSibling(m.group(1))), m.group(1));
            liens++;
        }
        assertTrue(liens >= 8, liens + " liens");
        assertTrue(lire(COURBES).contains("(stabilite-cas.md)"), "une page mène à l'autre");
        assertTrue(lire(Paths.get("README.md")).contains("(docs/stabilite.md)"), "le README y mène");
    }
}
