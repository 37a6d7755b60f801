package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import lancer.Main;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Le chemin d'un premier rayon est celui que le README fait suivre : une forme qui relève sa pile le dit. */
class CheminTest {

    /** Cadres de pile qu'il faut lire au plus, de la naissance du fil à la forme. */
    private static final int CADRES_MAX = 9;

    private static final String PILE = "lancer.essai.pile";

    private static final String ESPION = "package espion;\n"
            + "public final class Espion extends lancer.Objet3D implements lancer.contrat.Forme {\n"
            + "    public String getSection() { return \"Espion\"; }\n"
            + "    public String[] getCles() { return new String[0]; }\n"
            + "    public lancer.Objet3D lire(lancer.contrat.Section valeurs) { return new Espion(); }\n"
            + "    public lancer.Vecteur getNormale(lancer.Point contact) { return new lancer.Vecteur(0, 0, -1); }\n"
            + "    public double getIntersectionDistance(lancer.Rayon incident) {\n"
            + "        if (System.getProperty(\"" + PILE + "\") == null) {\n"
            + "            StringBuilder pile = new StringBuilder();\n"
            + "            for (StackTraceElement cadre : new Throwable().getStackTrace()) {\n"
            + "                pile.insert(0, cadre.getClassName() + '.' + cadre.getMethodName() + ' ');\n"
            + "            }\n"
            + "            System.setProperty(\"" + PILE + "\", pile.toString());\n"
            + "        }\n"
            + "        incident.setContact(this, Double.POSITIVE_INFINITY);\n"
            + "        return Double.POSITIVE_INFINITY;\n"
            + "    }\n"
            + "}\n";

    @TempDir
    Path dossier;

    @Test
    void lePremierRayonSuitLesEtapesDuReadmeEnNeufCadresAuPlus() throws IOException {
        List<String> vue = pile("--fils", "2");
        assertTrue(vue.size() <= CADRES_MAX, vue.size() + " cadres : " + vue);
        List<String> ecrite = new ArrayList<>(vue);
        assertEquals("espion.Espion.getIntersectionDistance", ecrite.remove(ecrite.size() - 1));
        assertEquals(new ArrayList<>(new LinkedHashSet<>(classes(vue))), classes(vue), "une classe ne revient pas");
        ecrite.replaceAll(cadre -> cadre.replaceAll("^(?:[a-z]+\\.)+", "").replaceAll("\\$\\d*", "."));
        ecrite.add("getIntersectionDistance");
        assertEquals(ecrite, etapes());
    }

    @Test
    void avecSimpleCeSontLesBouclesDuCoursQuiLeDemandent() throws IOException {
        List<String> vue = pile("--simple");
        assertEquals(Arrays.asList("lancer.Scene.getClosestIntersection", "lancer.Scene.demander"),
                vue.subList(vue.size() - 3, vue.size() - 1));
        assertTrue(vue.size() < CADRES_MAX, vue.toString());
    }

    /** Les classes de cette pile, chacune une fois par passage. */
    private static List<String> classes(List<String> pile) {
        List<String> classes = new ArrayList<>();
        for (String cadre : pile) {
            String classe = cadre.substring(0, cadre.lastIndexOf('.')).replaceAll("\\$.*", "");
            if (classes.isEmpty() || !classe.equals(classes.get(classes.size() - 1))) {
                classes.add(classe);
            }
        }
        return classes;
    }

    private List<String> pile(String... options) throws IOException {
        Path source = Files.write(dossier.resolve("Espion.java"), ESPION.getBytes(StandardCharsets.UTF_8));
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "-d", dossier.toString(), "-cp",
                Essai.origine(Main.class).toString(), source.toString()));
        Path services = Files.createDirectories(dossier.resolve("META-INF/services"));
        Files.write(services.resolve("lancer.contrat.Forme"), Collections.singletonList("espion.Espion"));
        // d'une ou deux, il n'y aurait pas à chercher
        List<String> sections = new ArrayList<>();
        for (int k = 0; k < 50; k++) {
            sections.add("[Espion " + k + "]");
        }
        Path scene = Files.write(dossier.resolve("s.ini"), sections);
        List<String> args = new ArrayList<>(Arrays.asList("--taille", "16x12", "--image", dossier.resolve("i.png").toString()));
        args.addAll(Arrays.asList(options));
        args.add(scene.toString());
        System.clearProperty(PILE);
        try (Essai.Isole programme = new Essai.Isole(Collections.singletonList(dossier))) {
            Essai essai = programme.executer(args.toArray(new String[0]));
            assertEquals(0, essai.code, essai.toString());
            return Arrays.asList(System.getProperty(PILE).trim().split(" "));
        } finally {
            System.clearProperty(PILE);
        }
    }

    /** Les étapes numérotées de « Suivre un rayon ». */
    private static List<String> etapes() throws IOException {
        String readme = new String(Files.readAllBytes(Paths.get("README.md")), StandardCharsets.UTF_8);
        String section = readme.split("\n## Suivre un rayon\n")[1].split("\n## ")[0];
        List<String> etapes = new ArrayList<>();
        Matcher m = Pattern.compile("(?m)^" + "\\d+\\. \\[`([\\w.]+)`\\]").matcher(section);
        while (m.find()) {
            etapes.add(m.group(1));
        }
        return etapes;
    }
}
