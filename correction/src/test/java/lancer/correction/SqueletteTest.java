package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import lancer.correction.modele.SourcesDuCours;
import org.ini4j.Ini;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Le projet que reçoivent les étudiants. */
class SqueletteTest extends ClasseEssai {

    /** Où sont les classes du projet. */
    private static final String LANCER = "src/main/java/lancer/";

    private static final JavaCompiler JAVAC = ToolProvider.getSystemJavaCompiler();
    /** Un seul pour tous : il garde ouvertes les classes de Java et les bibliothèques. */
    private static final StandardJavaFileManager GESTION = JAVAC.getStandardFileManager(null, null, StandardCharsets.UTF_8);

    @TempDir
    Path dossier;

    /** Compile les classes du projet, comme pour Java 8, et rend ce que le compilateur en dit. */
    private String compiler(Path sources, Path classes) throws IOException, URISyntaxException {
        return compiler(sources, classes, ini4j(), "--release", "8");
    }

    static String compiler(Path sources, Path classes, String chemin, String... options) throws IOException {
        StringWriter dit = new StringWriter();
        List<String> toutes = new ArrayList<>(List.of("-Xlint:all,-options", "-d", Files.createDirectories(classes).toString(), "-cp",
                chemin));
        toutes.addAll(List.of(options));
        try (Stream<Path> flux = Files.walk(sources)) {
            List<File> fichiers = flux.filter(f -> f.toString().endsWith(".java")).map(Path::toFile).collect(Collectors.toList());
            JAVAC.getTask(dit, GESTION, null, toutes, null, GESTION.getJavaFileObjectsFromFiles(fichiers)).call();
        }
        return dit.toString();
    }

    private static String ini4j() throws URISyntaxException {
        return Path.of(Ini.class.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
    }

    /** Ce que dessine le programme d'un projet, dans cette machine virtuelle. */
    private BufferedImage dessiner(Path classes, Path scene) throws Exception {
        Path image = dossier.resolve("image.png");
        URL[] chemin = {classes.toUri().toURL(), Path.of(ini4j()).toUri().toURL()};
        try (URLClassLoader chargeur = new URLClassLoader(chemin, ClassLoader.getPlatformClassLoader())) {
            chargeur.loadClass("lancer.Main").getMethod("main", String[].class).invoke(null,
                    (Object) new String[] {scene.toString(), image.toString()});
        }
        return ImageIO.read(image.toFile());
    }

    @Test
    void seConstruitSansAvertissementEtDessineUneImageToutVerte() throws Exception {
        Path projet = dossier.resolve("projet");
        assertEquals(0, executer("--squelette", projet).code);
        assertEquals("", compiler(projet.resolve("src/main/java"), dossier.resolve("classes")));
        assertEquals("", compiler(projet.resolve("src/test/java"), dossier.resolve("tests"), dossier.resolve("classes") + File.pathSeparator
                + System.getProperty("java.class.path"), "--release", "8", "-proc:none"));
        BufferedImage image = dessiner(dossier.resolve("classes"), projet.resolve("scenes/scene1.ini"));
        assertTrue(Arrays.stream(image.getRGB(0, 0, 800, 600, null, 0, 800)).allMatch(c -> c == 0xFF00FF00));
        contient(main(projet, "scenes/scene1.ini"), "statut 1 : Pas d'", "make IMAGE=image.png");
        // une scène n'est jamais écrasée, et un dossier au-dessus a les siennes
        contient(main(projet, "scenes/scene1.ini", "scenes/ombres.ini"), "statut 2 : image impossible");
        contient(main(projet, "scenes/scene1.ini", "absent/image.png"), "statut 1 : ", "criture impossible : absent/image.png");
        contient(main(projet, "scenes/scene1.ini scenes/ombres.ini", "image.png"), "statut 2 : sc", "introuvable");
        assertEquals("statut 0 : ", main(projet.resolve("src/main"), "scenes/scene1.ini", "une image.PNG"));
        assertEquals(SourcesDuCours.scene("ombres"), Files.readString(projet.resolve("scenes/ombres.ini")));
    }

    /** Le statut du programme d'un projet lancé dans ce dossier, et l'unique ligne qu'il dit, s'il en dit une. */
    private String main(Path ici, String... arguments) throws Exception {
        List<String> commande = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.awt.headless=true", "-cp", dossier.resolve("classes") + File.pathSeparator + ini4j(), "lancer.Main"));
        commande.addAll(List.of(arguments));
        Process main = new ProcessBuilder(commande).directory(ici.toFile()).redirectErrorStream(true).start();
        String dit = new String(main.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertTrue(dit.matches("([^\n]+\n)?"), dit);
        return "statut " + main.waitFor() + " : " + dit;
    }

    @ParameterizedTest
    @CsvSource({"4, scene", "5, lambert", "6, phong", "7, ombres", "8, reflets"})
    void lImageAttendueAUneEtapeEstCelleDuCorrigeCoupeLa(int etape, String nom) throws Exception {
        Path scene = Files.writeString(dossier.resolve("scene.ini"), SourcesDuCours.scene(nom.equals("lambert") ? "diffus" : "scene1"));
        Method tracer = new Programme(dossier).couper(etape).chargeur().loadClass("lancer.ImageAttendue")
                .getDeclaredMethod("tracer", String.class, int.class, int.class);
        tracer.setAccessible(true);
        BufferedImage image = (BufferedImage) tracer.invoke(null, scene.toString(), 120, 90);
        Path fichier = Path.of("src/modele/projet", SourcesDuCours.ATTENDUES, nom + ".png");
        if (Boolean.getBoolean("references.refaites")) {
            ImageIO.write(image, "png", fichier.toFile());
        }
        assertArrayEquals(image.getRGB(0, 0, 120, 90, null, 0, 120), ImageIO.read(fichier.toFile()).getRGB(0, 0, 120, 90, null, 0, 120));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "[Lampe a];position=0 0 0;couleur=1 1 1;[Lampe a];position=1 0 0;couleur=1 1 1 "
            + "| :4, [Lampe a] : attendu, un autre nom : celui-ci est déjà pris",
        "[Sphere a];rayon=1;centre=0,5 0 6 | :3, [Sphere a], centre : attendu, 3 nombres séparés par des blancs, avec un point décimal ; "
            + "obtenu, « 0,5 0 6 »",
        "[Sphere a];rayon=1;[Sphere b];centre=0 0 6 | :1, [Sphere a], centre : attendu, 3 nombres séparés par des blancs, une fois",
        "[Sphere a];centre=0 0 6;rayon=1;rayon=2 | :4, [Sphere a], rayon : attendu, un nombre, une fois",
        "[Sphere a];CENTRE=0 0 6;rayon=1;kd=1 1 1;nss=3 | :5, [Sphere a], nss : attendu, l'une des clés centre, rayon, Kd, Ks, Kr, ns",
        "[Sphère a];centre=0 0 6;rayon=1 | :1, [Sphère a] : attendu, une section [Sphere …] ou [Lampe …]"})
    void uneSceneFautiveEstRefuseeAvecSaLigne(String scene, String refus) throws Exception {
        Path fichier = Files.writeString(dossier.resolve("fautive.ini"), "\uFEFF" + scene.trim().replace(";", "\n") + "\n");
        InvocationTargetException leve = assertThrows(InvocationTargetException.class, () -> new Programme(dossier).chargeur()
                .loadClass("lancer.Scene").getConstructor(String.class).newInstance(fichier.toString()));
        assertEquals(fichier + refus.trim(), leve.getCause().getMessage());
    }

    @Test
    void neContientNiLesReponsesNiLaRechercheRapide() throws IOException {
        Path projet = dossier.resolve("projet");
        executer("--squelette", projet);
        int aFaire = 0;
        try (Stream<Path> flux = Files.walk(projet)) {
            for (Path fichier : flux.filter(Files::isRegularFile).collect(Collectors.toList())) {
                String texte = Files.readString(fichier, StandardCharsets.ISO_8859_1);
                aFaire += texte.split("// FIXME ", -1).length - 1;
                assertTrue(!texte.contains("//{") && !texte.contains("//=") && !texte.contains("lancer.rapide"), fichier.toString());
            }
        }
        assertEquals(16, aFaire, "endroits à compléter");
        assertTrue(Files.exists(projet.resolve("src/test/java/lancer/Tests.java")) && Files.exists(projet.resolve("pom.xml")));
    }

    /** Le projet achevé, vide pour la base, ou la copie de cette extension. */
    private Path corrige(String variante) {
        Path projet = dossier.resolve("corrigé" + variante);
        assertEquals(0, (variante.isEmpty() ? executer("--corrige", projet) : executer("--corrige", projet, "--variante", variante)).code);
        return projet;
    }

    @ParameterizedTest
    @CsvSource({"'', scene1 miroirs", "brume, brume scene1", "antialias, scene1", "blinn, bowling"})
    void leCorrigeEtSesExtensionsDessinentLImageDeNotreProgramme(String variante, String scenes) throws Exception {
        Path projet = corrige(variante);
        // le cours n'a qu'une taille d'image
        changer(projet.resolve(LANCER), "Constantes", "LARGEUR_IMAGE = 800", "LARGEUR_IMAGE = 100");
        changer(projet.resolve(LANCER), "Constantes", "HAUTEUR_IMAGE = 600", "HAUTEUR_IMAGE = 75");
        assertEquals("", compiler(projet.resolve("src/main/java"), dossier.resolve("classes")));
        List<String> autres = new ArrayList<>(List.of("Brume", "Antialias", "Blinn"));
        autres.removeIf(v -> v.equalsIgnoreCase(variante));
        Method executer = Class.forName("lancer.Main").getDeclaredMethod("executer", String[].class, PrintStream.class, PrintStream.class);
        executer.setAccessible(true);
        for (String scene : scenes.split(" ")) {
            Path fichier = projet.resolve("scenes/" + scene + ".ini");
            dessiner(dossier.resolve("classes"), fichier);
            ByteArrayOutputStream octets = new ByteArrayOutputStream();
            PrintStream dit = new PrintStream(octets, true, "UTF-8");
            // le corrigé suit un reflet jusqu'au bout : seuil nul
            Object statut = executer.invoke(null, new String[] {"--seuil", "0", "--sans", String.join(",", autres), "--comparer",
                dossier.resolve("image.png").toString(), fichier.toString()}, dit, dit);
            assertEquals(0, statut, octets.toString(StandardCharsets.UTF_8));
            contient(octets.toString(StandardCharsets.UTF_8), "plus grand écart: 0.0000");
        }
    }

    @Test
    void uneExtensionQueLeCoursNAPasEstRefusee() {
        executer("--corrige", dossier.resolve("flou"), "--variante", "flou").exigerRefus("attendu : antialias, blinn, brume");
    }

    /** Ce que dit « make test » dans ce projet, et pour finir son statut. */
    private String makeTest(Path projet) throws IOException, InterruptedException {
        return make(projet, "test", "MVN=mvn -B -ntp -q -o", "PATIENCE=2");
    }

    private static String make(Path projet, String... arguments) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/make")) && Files.isExecutable(Path.of("/usr/bin/mvn")), "ni make ni Maven ici");
        List<String> commande = new ArrayList<>(List.of("make", "-s"));
        commande.addAll(List.of(arguments));
        ProcessBuilder make = new ProcessBuilder(commande).directory(projet.toFile()).redirectErrorStream(true);
        make.environment().keySet().removeAll(List.of("MAKEFLAGS", "MFLAGS", "MAKELEVEL"));
        // le dossier a un accent, que seule une machine en UTF-8 lit
        make.environment().put("LC_ALL", "C");
        make.environment().put("MAVEN_OPTS", "-XX:TieredStopAtLevel=1");
        Process lance = make.start();
        String dit = new String(lance.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return dit + "statut " + lance.waitFor();
    }

    /** Donne sa réponse à cette classe du projet à compléter. */
    private static void completer(Path projet, String classe) {
        try {
            Files.writeString(projet.resolve(LANCER + classe + ".java"), SourcesDuCours.corrige(classe));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** La ligne de ce texte qui commence ainsi. */
    private static String ligne(String texte, String debut) {
        return Arrays.stream(texte.split("\n")).filter(l -> l.startsWith(debut)).findFirst().orElse("rien ne commence par " + debut
                + " : " + texte);
    }

    @Test
    void makeTestDitOuLOnEnEst() throws Exception {
        String dit = new Programme(dossier).couper(3).bilan();
        assertEquals("3. Intersection d'un rayon et d'une sphère : 7/7", ligne(dit, "3."));
        contient(ligne(dit, "4."), "; à commencer : getClosestIntersection ne trouve encore rien");
        contient(ligne(dit, "8."), "0/8");
        contient(ligne(dit, "L'étape suivante"), "4. Scène de sphères ; à compléter : Scene.java:");
        Programme vierge = new Programme(dossier);
        SourcesDuCours.A_COMPLETER.forEach(classe -> vierge.ecrire(classe, SourcesDuCours.squelette(classe)));
        dit = vierge.bilan();
        assertTrue(dit.matches("(?s)\\n([1-8]\\. [^\\n]* ; à commencer : [^\\n]*\\n){8}9.*") && !dit.contains("à reprendre"), dit);
        contient(ligne(dit, "L'étape suivante"), "1. Points et vecteurs ; à compléter : Vecteur.java:");

        Path projet = dossier.resolve("projet");
        executer("--squelette", projet);
        SourcesDuCours.A_COMPLETER.forEach(classe -> completer(projet, classe));
        // un verrou d'Emacs, qui ne mène nulle part, et une copie de l'Explorateur, dont le nom a des blancs, n'arrêtent pas make
        Files.createSymbolicLink(projet.resolve(LANCER + ".#Sphere.java"), Path.of("emacs@ici:1"));
        Files.copy(projet.resolve(LANCER + "Sphere.java"), projet.resolve(LANCER + "Sphere - Copie.java"));
        assertEquals("statut 0", make(projet, "target/lancer-base.jar", "MVN=mkdir -p target; true"));
        // une étape juste ne doit rien à celle d'avant qui ne finit pas ; ni Maven ni la pile n'en disent plus
        changer(projet.resolve(LANCER), "Sphere", "if (delta >= 0) {", "while (delta >= 0) {");
        dit = makeTest(projet);
        contient(dit, "sans réponse après 2 secondes");
        contient(ligne(dit, "5."), "0/9 ; le reste n'est pas évaluable");
        contient(ligne(dit, "L'étape suivante"), "3. Intersection d'un rayon et d'une sphère ; à reprendre : Sphere.java:");
        assertTrue(!dit.contains("[ERROR]") && !dit.contains("access$"), dit);

        completer(projet, "Sphere");
        // isBlank est de Java 11, et le projet de Java 8
        changer(projet.resolve(LANCER), "Sphere", "double racine", "duble blanc = \"\".isBlank() ? 0 : 1, racine");
        dit = makeTest(projet);
        contient(dit, "Le projet ne se compile pas :\n  src/main/java/lancer/Sphere.java:[");
        contient(dit, "class duble", "method isBlank");
        assertTrue(dit.endsWith("statut 2") && !dit.contains("renommée"), dit);
    }

    @Test
    void makeTestDemandeSiUneMethodeEstRenommee() throws Exception {
        Path projet = corrige("");
        for (String classe : List.of("Vecteur", "Sphere", "Objet3D")) {
            changer(projet.resolve(LANCER), classe, "dot(", "scalaire(");
        }
        String dit = makeTest(projet);
        contient(dit, "Tests.java:[", "method dot(", "\nClasse ou méthode renommée ? Les noms du cours ne changent pas");
        assertTrue(dit.endsWith("statut 2"), dit);
    }

    @Test
    void lesTestsDuCorrigePassent() throws Exception {
        contient(makeTest(corrige("blinn")),
                "Toutes les étapes sont faites : restent les extensions.\nstatut 0");
        for (String variante : List.of("antialias", "brume")) {
            Programme programme = new Programme(dossier);
            SourcesDuCours.acheve(variante).forEach((classe, texte) -> programme.ecrire(classe.replace("lancer/", ""), texte));
            assertEquals(Map.of(), programme.rates(0), variante);
        }
    }

    @Test
    void nEcrasePasUnDossierQuiContientDejaQuelqueChose() throws IOException {
        Files.write(dossier.resolve("travail.txt"), new byte[1]);
        executer("--squelette", dossier).exigerRefus("n'est pas vide");
        assertEquals(new ArrayList<>(List.of("travail.txt")), List.of(dossier.toFile().list()));
    }
}
