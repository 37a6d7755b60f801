package lancer.brume;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.ZipFile;
import javax.imageio.ImageIO;
import lancer.essai.Essai;
import lancer.essai.Ressources;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Une variante de plus, faite en suivant docs/etendre.md à la lettre dans une copie du projet : rien de la base ne change. */
class QuatriemeVarianteTest {

    private static final Pattern FICHIER = Pattern.compile("`([^`]+)` :");
    private static final Pattern INSERTION = Pattern.compile("Dans `([^`]+)`, sous `([^`]+)` :");

    private static final Pattern AILLEURS = Pattern.compile("(brume|antialias|blinn|mesures|correction)/src|mesures/resultats|"
            + "images|docs|src/test/(resources|java/lancer/(?!essai).*)");

    @TempDir
    static Path copie;
    @TempDir
    Path dossier;

    /** Ce qu'a dit la dernière commande de la page. */
    private static String dit;

    @BeforeAll
    static void suivreLaPage() throws Exception {
        for (String outil : new String[] {"make", "mvn", "sed"}) {
            assumeTrue(Arrays.stream(System.getenv("PATH").split(File.pathSeparator)).anyMatch(d -> new File(d, outil).canExecute()),
                    "pas de " + outil + " ici");
        }
        copier(Path.of("..").toRealPath());
        String page = Files.readString(Path.of("../docs/etendre.md"));
        String partie = page.substring(page.indexOf("## Une quatrième variante\n"), page.indexOf("## Une forme à soi\n"));
        String prose = "";
        StringBuilder bloc = new StringBuilder();
        for (String ligne : (partie + "fin").split("\n")) {
            if (ligne.isEmpty() || ligne.startsWith("    ")) {
                bloc.append(ligne.isEmpty() ? "" : ligne.substring(4)).append('\n');
                continue;
            }
            if (!bloc.toString().trim().isEmpty()) {
                suivre(prose, bloc.toString().replaceAll("^\n+|(?<=\n)\n+$", ""));
            }
            bloc.setLength(0);
            prose = ligne;
        }
    }

    /** Un bloc de la page est un fichier à écrire, des lignes à ajouter, ou des commandes : ce qui est dit juste avant le dit. */
    private static void suivre(String prose, String bloc) throws Exception {
        Matcher fichier = FICHIER.matcher(prose);
        Matcher insertion = INSERTION.matcher(prose);
        if (fichier.matches()) {
            Files.writeString(copie.resolve(fichier.group(1)), bloc);
        } else if (insertion.matches()) {
            Path ou = copie.resolve(insertion.group(1));
            String avant = Files.readString(ou);
            int ligne = avant.indexOf('\n', avant.indexOf(insertion.group(2))) + 1;
            Files.writeString(ou, (avant.substring(0, ligne) + bloc + avant.substring(ligne)));
        } else {
            Path sortie = copie.resolve("sortie.txt");
            ProcessBuilder sh = new ProcessBuilder("sh", "-e", "-c", bloc).directory(copie.toFile())
                    .redirectErrorStream(true).redirectOutput(sortie.toFile());
            // ni l'écran, ni les réglages du make qui lance ces tests ; et le même Java qu'eux
            sh.environment().keySet().removeAll(List.of("DISPLAY", "MVN", "MAKEFLAGS", "MAKELEVEL", "MFLAGS"));
            String java = System.getProperty("java.home");
            sh.environment().put("JAVA_HOME", java);
            sh.environment().put("PATH", java + File.separator + "bin" + File.pathSeparator + System.getenv("PATH"));
            int statut = sh.start().waitFor();
            dit = Files.readString(sortie);
            assertEquals(0, statut, bloc + dit);
        }
    }

    /** Tout, sauf ce qu'aucune commande de la page ne lit ici : les autres variantes, les mesures, la correction, les tests de la base. */
    private static void copier(Path projet) throws IOException {
        for (Path fichier : Ressources.fichiers(projet, dossier -> !dossier.getFileName().toString().matches("target|\\.(?!mvn).*")
                && !AILLEURS.matcher(projet.relativize(dossier).toString().replace(File.separatorChar, '/')).matches())) {
            Path ici = copie.resolve(projet.relativize(fichier).toString());
            Files.createDirectories(ici.getParent());
            Files.copy(fichier, ici);
        }
    }

    private static List<Path> nuit() {
        return List.of(copie.resolve("nuit/target/nuit.jar"));
    }

    private String boule(String... suite) throws IOException {
        return Essai.scene(dossier.resolve("boule.ini"), "[Sphere 1]", "centre=0 0 6", "rayon=1", "Kd=1 1 1", "[Lampe 1]",
                "position=0 0 -10", "couleur=1 1 1", String.join("\n", suite)).toString();
    }

    @Test
    void sesTestsSontFaitsEtSansEcranLImageEstDansSonDossier() throws IOException {
        assertTrue(dit.contains("Running lancer.nuit.NuitTest") && dit.contains("Tests run: 1, Failures: 0"), dit);
        Path png = copie.toRealPath().resolve("nuit/target/nuit.png");
        assertTrue(dit.contains("Pas d'écran ici : l'image est dans " + png + "\n"), dit);
        assertEquals(800, ImageIO.read(png.toFile()).getWidth());
        assertFalse(Files.exists(copie.resolve("target/scene1.png")));
    }

    @Test
    void sonArchivePorteLaLicenceDIni4j() throws IOException {
        try (ZipFile archive = new ZipFile(copie.resolve("nuit/target/nuit.jar").toFile())) {
            assertTrue(archive.getEntry("META-INF/licences/ini4j.txt").getSize() > 10_000);
        }
    }

    @Test
    void elleSInstalleSansRienChangerALaBase() throws Exception {
        // le contact est à 5 unités, soit deux portées, éclairé de face
        assertEquals(0.25, Essai.dessinerAvec(nuit(), dossier, Path.of(boule("[nuit]", "portee=2.5")), "--taille=1x1")[0], 1e-7);
    }

    @Test
    void sonModulePeutAussiApporterUneForme() throws Exception {
        Path essais = Essai.origine(Disque.class);
        List<Path> nuit = List.of(copie.resolve("nuit/target/nuit.jar"), essais, essais.resolve("quatrieme"));
        String[] lignes = {"[Disque 1]", "centre=0.5 0 5", "normale=0 0 -1", "rayon=1", "Kd=1 1 1", "[Lampe 1]", "position=0 0 -10",
            "couleur=1 1 1", "[Nuit]", "portee=2.5"};
        Path scene = Essai.scene(dossier.resolve("disque.ini"), lignes);
        assertEquals(0.25, Essai.dessinerAvec(nuit, dossier, scene, "--taille=1x1")[0], 1e-7);
        assertArrayEquals(Essai.dessinerAvec(nuit, dossier, scene, "--taille=40x30", "--simple"),
                Essai.dessinerAvec(nuit, dossier, scene, "--taille=40x30"));
        lignes[1] = "centre=1.5 0 5";
        // à côté, le ciel, dans la nuit
        assertEquals(0, Essai.dessinerAvec(nuit, dossier, Essai.scene(scene, lignes), "--taille=1x1")[0]);
        lignes[3] = "rayon=0";
        Essai.executerAvec(nuit, "--lineaire", dossier.resolve("a.pfm").toString(), Essai.scene(scene, lignes).toString()).exigerRefus(2,
                scene + ", ligne 4, [Disque 1], rayon : hors limites : « 0 » ; attendu : un nombre de 1e-100 à 1e100");
    }

    @Test
    void saSectionALesMessagesDeLaBase() throws Exception {
        String scene = boule("[Nuit]", "portee=0");
        Essai.executerAvec(nuit(), "--lineaire", dossier.resolve("nuit.pfm").toString(), scene).exigerRefus(2, scene
                + ", ligne 9, [Nuit], portee : hors limites : « 0 » ; attendu : un nombre plus grand que 0, au plus 1000000");
    }

    @Test
    void sansElleSaSectionEstRefusee() throws Exception {
        String scene = boule("[Nuit]", "portee=2.5");
        Essai essai = Essai.executerAvec(List.of(), "--lineaire", dossier.resolve("nuit.pfm").toString(), scene);
        assertEquals("lancer : " + scene + ", ligne 8, [Nuit] : type de section inconnu ; attendu : Sphere, Lampe, Camera, Brume, "
                + "Antialias, Blinn" + System.lineSeparator(), essai.sansAutresFormes("aucune"));
        assertEquals(2, essai.code);
    }

    @Test
    void deuxVariantesQuiVeulentLAirSontNommeesToutesDeux() throws Exception {
        Path image = dossier.resolve("nuit.pfm");
        List<Path> classes = List.of(nuit().get(0), Essai.origine(Brume.class));
        Essai.executerAvec(classes, "--lineaire", image.toString(), boule()).exigerRefus(2, "deux variantes veulent changer l'air : "
                + "lancer.nuit.Nuit et lancer.brume.Brume ; attendu : une seule des deux dans le chemin des classes");
        assertFalse(Files.exists(image));
    }
}
