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

/** Le chemin d'un premier rayon est celui que docs/etendre.md fait suivre : une pile, relevée pendant le dessin, le prouve. */
class CheminTest {

    /** Cadres de pile qu'il faut lire au plus, de la naissance du fil au calcul de la distance. */
    private static final int CADRES_MAX = 9;

    /** La boucle de la scène, et ce qu'elle fait pour chaque objet proposé. */
    private static final List<String> DEMANDER = Arrays.asList("lancer.Scene.getClosestIntersection", "lancer.Scene.demander");

    private static final String PILE = "lancer.essai.pile";

    /** Relève la pile du premier appel que demande le calcul d'un pixel. */
    private static final String RELEVER = "        if (System.getProperty(\"" + PILE + "\") == null) {\n"
            + "            StringBuilder pile = new StringBuilder();\n"
            + "            for (StackTraceElement cadre : new Throwable().getStackTrace()) {\n"
            + "                pile.insert(0, cadre.getClassName() + '.' + cadre.getMethodName() + ' ');\n"
            + "            }\n"
            + "            if (pile.indexOf(\"getCouleurPixel\") >= 0) {\n"
            + "                System.setProperty(\"" + PILE + "\", pile.toString());\n"
            + "            }\n"
            + "        }\n";

    private static final String ESPION = "package espion;\n"
            + "public final class Espion extends lancer.Objet3D implements lancer.contrat.Forme {\n"
            + "    public String getSection() { return \"Espion\"; }\n"
            + "    public String[] getCles() { return new String[0]; }\n"
            + "    public lancer.Objet3D lire(lancer.contrat.Section valeurs) { return new Espion(); }\n"
            + "    public lancer.Vecteur getNormale(lancer.Point contact) { return new lancer.Vecteur(0, 0, -1); }\n"
            + "    public double getIntersectionDistance(lancer.Rayon incident) {\n"
            + RELEVER
            + "        incident.setContact(this, Double.POSITIVE_INFINITY);\n"
            + "        return Double.POSITIVE_INFINITY;\n"
            + "    }\n"
            + "}\n";

    @TempDir
    Path dossier;

    @Test
    void dansLaSceneDuCoursLePremierRayonSuitLesEtapesDeLaPage() throws IOException {
        List<String> vue = pileDesSpheres("--fils", "2");
        assertTrue(vue.size() <= CADRES_MAX, vue.size() + " cadres : " + vue);
        assertEquals(new ArrayList<>(new LinkedHashSet<>(classes(vue))), classes(vue), "une classe ne revient pas");
        vue.replaceAll(cadre -> cadre.replaceAll("^(?:[a-z]+\\.)+", "").replaceAll("\\$\\d*", "."));
        assertEquals(vue, etapes());
    }

    @Test
    void avecSimpleLesBouclesDuCoursDemandentChaqueSphere() throws IOException {
        List<String> vue = pileDesSpheres("--simple");
        assertEquals(DEMANDER, vue.subList(vue.size() - 4, vue.size() - 2));
    }

    @Test
    void uneAutreFormeEstDemandeeUneParUne() throws IOException {
        Path services = Files.createDirectories(dossier.resolve("META-INF/services"));
        Files.write(services.resolve("lancer.contrat.Forme"), Collections.singletonList("espion.Espion"));
        // d'une ou deux, il n'y aurait pas à chercher
        List<String> sections = new ArrayList<>();
        for (int k = 0; k < 50; k++) {
            sections.add("[Espion " + k + "]");
        }
        List<String> vue = pile("Espion", ESPION, Files.write(dossier.resolve("s.ini"), sections), "--fils", "2");
        assertEquals(DEMANDER, vue.subList(vue.size() - 3, vue.size() - 1));
        assertEquals("espion.Espion.getIntersectionDistance", vue.get(vue.size() - 1));
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

    /** La pile du premier calcul de la distance d'une sphère, dans la scène du cours. */
    private List<String> pileDesSpheres(String... options) throws IOException {
        String source = Essai.texte("src/main/java/lancer/precision/Intersection.java");
        int corps = source.indexOf("{\n", source.indexOf("double distance(")) + 2;
        return pile("Intersection", source.substring(0, corps) + RELEVER + source.substring(corps),
                Paths.get("scenes/scene1.ini"), options);
    }

    private List<String> pile(String classe, String source, Path scene, String... options) throws IOException {
        Path java = Files.write(dossier.resolve(classe + ".java"), source.getBytes(StandardCharsets.UTF_8));
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "-encoding", "UTF-8", "-d", dossier.toString(),
                "-cp", Essai.origine(Main.class).toString(), java.toString()));
        List<String> args = new ArrayList<>(Arrays.asList("--taille", "400x300", "--image", dossier.resolve("i.png").toString()));
        args.addAll(Arrays.asList(options));
        args.add(scene.toString());
        System.clearProperty(PILE);
        try (Essai.Isole programme = new Essai.Isole(Collections.singletonList(dossier), Collections.<Path>emptyList())) {
            Essai essai = programme.executer(args.toArray(new String[0]));
            assertEquals(0, essai.code, essai.toString());
            return new ArrayList<>(Arrays.asList(System.getProperty(PILE).trim().split(" ")));
        } finally {
            System.clearProperty(PILE);
        }
    }

    /** Les étapes numérotées de « Suivre un rayon ». */
    private static List<String> etapes() throws IOException {
        String section = Essai.texte("docs/etendre.md").split("\n## Suivre un rayon\n")[1].split("\n## ")[0];
        List<String> etapes = new ArrayList<>();
        Matcher m = Pattern.compile("(?m)^" + "\\d+\\. \\[`([\\w.]+)`\\]").matcher(section);
        while (m.find()) {
            etapes.add(m.group(1));
        }
        return etapes;
    }
}
