package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.tools.ToolProvider;
import lancer.Main;
import org.ini4j.Config;

/** De quoi changer une classe de la base comme le ferait un étudiant, et la recompiler. */
public final class Modification {

    private static final Path SOURCES = Path.of("src/main/java/lancer");

    private Modification() {
    }

    /** Le programme où ce texte de cette classe est remplacé par celui-ci ({@code null} : par rien), et ainsi trois par trois. */
    public static Essai.Isole de(Path dossier, String... classesAnciensNouveaux) throws IOException {
        Map<String, String> sources = new LinkedHashMap<>();
        for (int k = 0; k < classesAnciensNouveaux.length; k += 3) {
            String classe = classesAnciensNouveaux[k];
            String ancien = classesAnciensNouveaux[k + 1];
            String nouveau = classesAnciensNouveaux[k + 2] == null ? "" : classesAnciensNouveaux[k + 2];
            String source = sources.containsKey(classe) ? sources.get(classe)
                    : Files.readString(SOURCES.resolve(classe + ".java"));
            assertTrue(source.contains(ancien), classe + " n'a plus « " + ancien + " »");
            sources.put(classe, source.replace(ancien, nouveau));
        }
        return compilee(dossier, sources);
    }

    /** Le programme où ces classes ont ces textes. */
    public static Essai.Isole compilee(Path dossier, Map<String, String> sources) throws IOException {
        Path classes = Files.createDirectories(dossier.resolve("classes"));
        List<String> javac = new ArrayList<>(List.of("-nowarn", "-encoding", "UTF-8", "-d", classes.toString(),
                "-cp", Essai.origine(Main.class) + File.pathSeparator + Essai.origine(Config.class)));
        for (Map.Entry<String, String> changee : sources.entrySet()) {
            Path source = dossier.resolve(Path.of(changee.getKey() + ".java").getFileName());
            javac.add(Files.writeString(source, changee.getValue()).toString());
        }
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, javac.toArray(new String[0])), sources.toString());
        return new Essai.Isole(List.of(classes), List.of());
    }
}
