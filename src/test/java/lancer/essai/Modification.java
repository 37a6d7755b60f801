package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import javax.tools.ToolProvider;
import lancer.Main;

/** De quoi changer une classe de la base comme le ferait un étudiant, et la recompiler. */
public final class Modification {

    private static final Path SOURCES = Paths.get("src/main/java/lancer");

    private Modification() {
    }

    /** Le programme où ce texte de cette classe est remplacé par celui-ci ; {@code null} : par rien. */
    public static Essai.Isole de(Path dossier, String classe, String ancienne, String nouvelle) throws IOException {
        String source = new String(Files.readAllBytes(SOURCES.resolve(classe + ".java")), StandardCharsets.UTF_8);
        assertTrue(source.contains(ancienne), classe + " n'a plus « " + ancienne + " »");
        Path changee = dossier.resolve(Paths.get(classe + ".java").getFileName());
        Files.write(changee, source.replace(ancienne, nouvelle == null ? "" : nouvelle).getBytes(StandardCharsets.UTF_8));
        Path classes = Files.createDirectories(dossier.resolve("classes"));
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "-nowarn", "-encoding", "UTF-8", "-d",
                classes.toString(), "-cp", Essai.origine(Main.class).toString(), changee.toString()));
        return new Essai.Isole(Collections.singletonList(classes), Collections.<Path>emptyList());
    }
}
