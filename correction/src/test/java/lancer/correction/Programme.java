package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.enfant.Execution;
import lancer.correction.jugement.Verification;
import lancer.correction.modele.SourcesDuCours;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.discovery.DiscoverySelectors;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/** Le corrigé, où l'on change ce que l'on veut, et sur lequel {@code lancer.Tests} se lance ici même. */
final class Programme {

    private static final String GRAINE = "tests.graine";
    /** Finit les boucles sans fin de {@code etapes.txt}, dont les fils occuperaient la machine. */
    private static final String ARRET = "tests.arret";

    private final Path dossier;
    private final Map<String, String> sources = SourcesDuCours.tout(SourcesDuCours::corrige);
    private final Map<String, String> changees = new TreeMap<>();
    private Map<String, byte[]> compilees;

    /** @param dossier où compiler, le même pour tous : le corrigé ne l'est qu'une fois */
    Programme(Path dossier) {
        this.dossier = dossier;
    }

    /** Une partie du texte d'une classe en devient une autre. */
    Programme changer(String classe, String avant, String apres) {
        String texte = sources.get("lancer/" + classe);
        assertTrue(texte.contains(avant), classe + " : " + avant);
        return ecrire(classe, texte.replace(avant, apres));
    }

    /** Ce qu'a écrit un étudiant qui en est à cette étape, de 1 à 8 : d'une classe d'après, il n'a que le squelette. */
    Programme couper(int etape) {
        Map.of("Rayon", 2, "Camera", 2, "Sphere", 3, "Scene", 4, "Lancer", 4, "Objet3D", 5).forEach((classe, sienne) -> {
            if (etape < sienne) {
                ecrire(classe, SourcesDuCours.squelette(classe));
            }
        });
        String[][] dansGetColor = {{"6", "Ks.mul(lampe.getCouleur()).mul(eclat)", "new Couleur()"},
            {"7", "!estALOmbre(scene, lampe, contact)", "contact != null"}, {"8", "if (profondeur > 0)", "if (profondeur > 1000)"}};
        String getColor = sources.get("lancer/Objet3D");
        for (String[] partie : dansGetColor) {
            getColor = etape >= 5 && etape < Integer.parseInt(partie[0]) ? getColor.replace(partie[1], partie[2]) : getColor;
        }
        return ecrire("Objet3D", getColor);
    }

    Programme ecrire(String classe, String texte) {
        sources.put("lancer/" + classe, texte);
        changees.put("lancer/" + classe, texte);
        compilees = null;
        return this;
    }

    /** La ligne où commence la méthode qui contient cette ligne-ci. */
    String methode(String classe, int ligne) {
        List<String> lignes = List.of(sources.get("lancer/" + classe).split("\n")).subList(0, ligne);
        return lignes.stream().filter(l -> l.matches("    (public|private|static).*\\{")).reduce("", (avant, apres) -> apres);
    }

    /** Les classes compilées, une fois pour toutes les graines. */
    private Map<String, byte[]> compiler() {
        if (compilees != null) {
            return compilees;
        }
        try {
            Path corrige = dossier.resolve("corrige");
            if (!Files.exists(corrige)) {
                Map<String, String> tout = SourcesDuCours.tout(SourcesDuCours::corrige);
                SourcesDuCours.VERIFICATIONS.forEach(v -> tout.put(v, SourcesDuCours.ressource("modele/" + v + ".java")));
                for (String classe : new String[] {"lancer/Etapes", "lancer/ImageAttendue"}) {
                    tout.put(classe, SourcesDuCours.ressource("projet/src/test/java/" + classe + ".java"));
                }
                compiler(tout, corrige, System.getProperty("java.class.path"));
            }
            Map<String, byte[]> classes = lire(corrige);
            if (!changees.isEmpty()) {
                Path ici = Files.createTempDirectory(dossier, "change");
                compiler(changees, ici, corrige + File.pathSeparator + System.getProperty("java.class.path"));
                classes.putAll(lire(ici));
            }
            compilees = classes;
            return classes;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void compiler(Map<String, String> sources, Path classes, String chemin) throws IOException {
        Path textes = Files.createTempDirectory(Files.createDirectories(classes), "textes");
        for (Map.Entry<String, String> source : sources.entrySet()) {
            Path fichier = textes.resolve(source.getKey() + ".java");
            Files.createDirectories(fichier.getParent());
            Files.writeString(fichier, source.getValue());
        }
        assertEquals("", SqueletteTest.compiler(textes, classes, chemin, "-proc:none"));
    }

    private static Map<String, byte[]> lire(Path classes) throws IOException {
        try (Stream<Path> flux = Files.list(classes.resolve("lancer"))) {
            Map<String, byte[]> lues = new HashMap<>();
            for (Path f : (Iterable<Path>) flux.filter(f -> f.toString().endsWith(".class"))::iterator) {
                lues.put("lancer." + f.getFileName().toString().replace(".class", ""), Files.readAllBytes(f));
            }
            return lues;
        }
    }

    /** Les valeurs des vérifications : tirées de cette graine ou, pour 0, celles de l'énoncé. */
    private static void tirer(long graine) {
        System.setProperty(GRAINE, graine == 0 ? "" : String.valueOf(graine));
    }

    /**
     * Les vérifications qui ne réussissent pas, par leur classe et leur nom, et pourquoi.
     *
     * @param graine d'où tirer les valeurs, 0 si elles ne le sont pas
     */
    Map<String, String> rates(long graine) {
        tirer(graine);
        Rates rates = new Rates();
        lancer(chargeur(), rates);
        return rates.pourquoi;
    }

    /** La même chose, pour chacune de ces graines. */
    Map<Long, Map<String, String>> rates(long... graines) {
        return Arrays.stream(graines).boxed().collect(Collectors.toMap(g -> g, g -> rates(g.longValue()), (a, b) -> a, TreeMap::new));
    }

    /** Retient ce qui ne réussit pas. */
    static final class Rates implements TestExecutionListener {

        final Map<String, String> pourquoi = new TreeMap<>();

        @Override
        public void executionFinished(TestIdentifier qui, TestExecutionResult resultat) {
            if (qui.isTest() && resultat.getStatus() != TestExecutionResult.Status.SUCCESSFUL) {
                pourquoi.put(Verification.demandee(qui) + "." + ((MethodSource) qui.getSource().get()).getMethodName(),
                        String.valueOf(resultat.getThrowable().get()));
            }
        }
    }

    private static void lancer(ClassLoader chargeur, TestExecutionListener... ecoutes) {
        System.clearProperty(ARRET);
        LauncherFactory.create().execute(LauncherDiscoveryRequestBuilder.request()
                .selectors(DiscoverySelectors.selectClass(chargeur, "lancer.Tests"))
                .enableImplicitConfigurationParameters(false).configurationParameter("tests.patience", "4").build(), ecoutes);
        System.setProperty(ARRET, "true");
    }

    /** Les classes de ce programme, à la place de celles de la base. */
    ClassLoader chargeur() {
        return new Execution.Classes(compiler(), Programme.class.getClassLoader());
    }

    /** Ce que dit « make test » : le bilan de la classe {@code Etapes}. */
    String bilan() throws IOException, ReflectiveOperationException {
        return bilan(0, new Rates());
    }

    /** @param graine d'où tirer les valeurs, 0 si elles ne le sont pas ; @param rates reçoit ce qui ne réussit pas */
    String bilan(long graine, Rates rates) throws IOException, ReflectiveOperationException {
        tirer(graine);
        Path projet = Files.createTempDirectory(dossier, "sources");
        for (Map.Entry<String, String> source : sources.entrySet()) {
            Files.writeString(projet.resolve(source.getKey().replace("lancer/", "") + ".java"), source.getValue());
        }
        System.setProperty("etapes.sources", projet.toString());
        PrintStream sortie = System.out;
        ByteArrayOutputStream dit = new ByteArrayOutputStream();
        System.setOut(new PrintStream(dit, true, "UTF-8"));
        try {
            ClassLoader chargeur = chargeur();
            lancer(chargeur, (TestExecutionListener) chargeur.loadClass("lancer.Etapes").getConstructor().newInstance(), rates);
        } finally {
            System.setOut(sortie);
            System.clearProperty("etapes.sources");
        }
        return dit.toString(StandardCharsets.UTF_8);
    }
}
