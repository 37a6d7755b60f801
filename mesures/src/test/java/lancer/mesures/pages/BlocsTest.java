package lancer.mesures.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lancer.mesures.Lancement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce qu'une page montre d'une scène s'écrit tel quel dans une scène : le programme, avec ses variantes, l'accepte. */
class BlocsTest {

    /**
     * Un bloc, lignes en retrait, ou un mot de code. {@code Plan} et {@code Nuit} n'existent que dans la page qui les fait
     * écrire.
     */
    private static final Pattern BLOC = Pattern.compile("(?m)(?:^ {4}.*\\n|^\\n(?= {4}))+|`[^`\\n]+`");
    private static final Pattern SECTION = Pattern.compile(
            "(?s)(?:;[^\\n]*\\n)*\\[(?!(?:Plan|Nuit)\\b)[A-Z][a-z]+\\b[^\\]\\n…]*\\].*");

    private static final String SCENE = "[Sphere du test]\ncentre=0 0 5\nrayon=1\n\n[Lampe du test]\nposition=0 9 0\ncouleur=1 1 1\n\n";

    @TempDir
    Path dossier;

    /** Les blocs qui commencent par une section, et où ils sont. */
    private static Map<String, String> blocs() throws IOException {
        List<Path> pages = new ArrayList<>();
        for (String lieu : new String[] {"", "docs", "brume", "antialias", "blinn", "mesures", "mesures/resultats", "correction"}) {
            try (Stream<Path> fichiers = Files.list(Path.of("..", lieu))) {
                fichiers.filter(f -> f.toString().endsWith(".md")).sorted().forEach(pages::add);
            }
        }
        Map<String, String> blocs = new LinkedHashMap<>();
        for (Path page : pages) {
            Matcher m = BLOC.matcher(Files.readString(page));
            while (m.find()) {
                String bloc = m.group().replaceAll("(?m)^ {4}|`", "").trim();
                if (SECTION.matcher(bloc).matches()) {
                    blocs.merge(bloc, page.getFileName().toString(), (a, b) -> a);
                }
            }
        }
        return blocs;
    }

    @Test
    void ceQueMontreUnePageSeColleDansUneScene() throws IOException {
        Map<String, String> blocs = blocs();
        assertTrue(blocs.size() > 4 && blocs.keySet().stream()
                .anyMatch(b -> b.contains("[Sphere rouge]") && b.contains("[Lampe 1]")), blocs.toString());
        for (Map.Entry<String, String> bloc : blocs.entrySet()) {
            Path scene = Files.writeString(dossier.resolve("scene.ini"), SCENE + bloc.getKey());
            Lancement programme = new Lancement(dossier.resolve("pris"), Path.of(System.getProperty("java.home"), "bin", "java"),
                    "-cp", System.getProperty("java.class.path"), "lancer.Main", "--taille", "4x3", "--image",
                    dossier.resolve("image.png"), scene);
            assertEquals("0 ", programme.statut + " " + programme.dit, bloc.getValue() + " :\n" + bloc.getKey());
        }
    }
}
