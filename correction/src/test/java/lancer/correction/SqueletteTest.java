package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import lancer.correction.modele.Modele;
import org.ini4j.Ini;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Le projet que reçoivent les étudiants. */
class SqueletteTest extends ClasseEssai {

    @TempDir
    Path dossier;

    /** Compile les classes du projet, comme pour Java 8, et rend ce que le compilateur en dit. */
    private String compiler(Path sources, Path classes) throws IOException, URISyntaxException {
        JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
        StringWriter dit = new StringWriter();
        try (StandardJavaFileManager gestion = javac.getStandardFileManager(null, null, StandardCharsets.UTF_8);
                Stream<Path> flux = Files.walk(sources)) {
            List<File> fichiers = flux.filter(f -> f.toString().endsWith(".java")).map(Path::toFile).collect(Collectors.toList());
            List<String> options = Arrays.asList("--release", "8", "-Xlint:all,-options", "-d", Files.createDirectories(classes).toString(),
                    "-cp", ini4j());
            javac.getTask(dit, gestion, null, options, null, gestion.getJavaFileObjectsFromFiles(fichiers)).call();
        }
        return dit.toString();
    }

    private static String ini4j() throws URISyntaxException {
        return Paths.get(Ini.class.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
    }

    private BufferedImage dessiner(Path classes, Path scene) throws IOException, URISyntaxException, InterruptedException {
        Path image = dossier.resolve("image.png");
        Process programme = new ProcessBuilder(Paths.get(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.awt.headless=true", "-cp",
                classes + File.pathSeparator + ini4j(), "lancer.Main", scene.toString(), image.toString()).inheritIO().start();
        assertEquals(0, programme.waitFor());
        return ImageIO.read(image.toFile());
    }

    @Test
    void seConstruitSansAvertissementEtDessineUneImageToutVerte() throws Exception {
        Path projet = dossier.resolve("projet");
        assertEquals(0, executer("--squelette", projet).code);
        assertEquals("", compiler(projet.resolve("src/main/java"), dossier.resolve("classes")));
        BufferedImage image = dessiner(dossier.resolve("classes"), projet.resolve("scenes/scene1.ini"));
        assertTrue(Arrays.stream(image.getRGB(0, 0, 800, 600, null, 0, 800)).allMatch(c -> c == 0xFF00FF00));
    }

    @Test
    void neContientNiLesReponsesNiLaRechercheRapide() throws IOException {
        Path projet = dossier.resolve("projet");
        executer("--squelette", projet);
        int aFaire = 0;
        try (Stream<Path> flux = Files.walk(projet)) {
            for (Path fichier : flux.filter(Files::isRegularFile).collect(Collectors.toList())) {
                String texte = new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
                aFaire += texte.split("// FIXME", -1).length - 1;
                assertTrue(!texte.contains("//{") && !texte.contains("//=") && !texte.contains("lancer.rapide"), fichier.toString());
            }
        }
        assertEquals(16, aFaire, "endroits à compléter");
        assertTrue(Files.exists(projet.resolve("src/test/java/lancer/Tests.java")) && Files.exists(projet.resolve("pom.xml")));
    }

    @Test
    void completeDApresLEnonceSeConstruitSansAvertissement() throws Exception {
        Path sources = Files.createDirectories(dossier.resolve("complet"));
        for (String classe : Modele.classes()) {
            Files.write(sources.resolve(classe + ".java"), Modele.corrige(classe).getBytes(StandardCharsets.UTF_8));
        }
        assertEquals("", compiler(sources, dossier.resolve("classes")));
    }

    @Test
    void nEcrasePasUnDossierQuiContientDejaQuelqueChose() throws IOException {
        Files.write(dossier.resolve("travail.txt"), new byte[1]);
        Essai essai = executer("--squelette", dossier);
        assertEquals(2, essai.code);
        contient(essai.erreur, "n'est pas vide");
        assertEquals(new ArrayList<>(List.of("travail.txt")), Arrays.asList(dossier.toFile().list()));
    }
}
