package lancer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.ini4j.spi.IniParser;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Le programme dans sa propre machine virtuelle : mémoire, langue, dossier de travail, flux et signaux. */
@Timeout(60)
class ProcessusTest {

    private static final String SCENE = Ressources.chemin("reference/p3-miroirs.ini");

    /** Compiler moins fait gagner du temps sur des programmes d'une demi-seconde. */
    private static final String[] RAPIDE = {"-XX:TieredStopAtLevel=1", "-Xshare:auto"};

    @TempDir
    Path dossier;
    private Path erreur;
    private Path sortie;
    private Process processus;

    @BeforeEach
    void nommerLesFlux() throws IOException {
        Path flux = Files.createDirectory(dossier.resolve("flux"));
        erreur = flux.resolve("erreur");
        sortie = flux.resolve("sortie");
    }

    @AfterEach
    void neLaisserAucunProcessus() {
        if (processus != null) {
            processus.destroyForcibly();
        }
    }

    private static String chemin(Class<?> classe) {
        try {
            return Paths.get(classe.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    private static List<String> java(String options, String... arguments) {
        List<String> commande = new ArrayList<>();
        commande.add(Paths.get(System.getProperty("java.home"), "bin", "java").toString());
        commande.addAll(Arrays.asList(RAPIDE));
        commande.addAll(Arrays.asList(options.trim().isEmpty() ? new String[0] : options.trim().split(" +")));
        commande.add("-cp");
        commande.add(chemin(Main.class) + File.pathSeparator + chemin(IniParser.class));
        commande.add("lancer.Main");
        commande.addAll(Arrays.asList(arguments));
        return commande;
    }

    private ProcessBuilder preparer(List<String> commande) {
        ProcessBuilder p = new ProcessBuilder(commande).directory(dossier.toFile());
        // ces variables font écrire à la machine virtuelle une ligne de plus
        p.environment().keySet().removeAll(Arrays.asList("JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS", "JDK_JAVA_OPTIONS"));
        return p.redirectError(erreur.toFile()).redirectOutput(sortie.toFile());
    }

    private int statut(ProcessBuilder p) throws IOException, InterruptedException {
        processus = p.start();
        return processus.waitFor();
    }

    private String erreur() throws IOException {
        return new String(Files.readAllBytes(erreur), StandardCharsets.UTF_8);
    }

    private String sortie() throws IOException {
        return new String(Files.readAllBytes(sortie), StandardCharsets.UTF_8);
    }

    private static void supposerUnix() {
        assumeTrue(Files.exists(Paths.get("/proc/self/status")) && Files.exists(Paths.get("/bin/sh")), "pas un Linux");
    }

    @Test
    void awtNEstPasChargeSurLeCheminDUnPng() throws Exception {
        assertEquals(0, statut(preparer(java("-verbose:class", "--image", "a.png", "--lineaire", "a.pfm", "--taille=80x60",
                "--statistiques", SCENE))),
                erreur());
        assertTrue(sortie().contains("lancer.Main "), "les classes chargées ne sont pas dites");
        for (String ligne : sortie().split("\r?\n")) {
            assertFalse(ligne.matches(".*\\b(java\\.awt|javax\\.swing|sun\\.awt|javax\\.imageio|lancer\\.sortie\\.Fenetre)\\b.*"), ligne);
        }
    }

    @Test
    void uneSceneRelativeEstChercheeAussiUnDossierPlusHaut() throws Exception {
        Path scenes = Files.createDirectories(dossier.resolve("scenes"));
        Path variante = Files.createDirectories(dossier.resolve("brume"));
        Files.write(scenes.resolve("s.ini"), Arrays.asList("[Sphere]", "centre=0 0 6", "rayon=1"));
        assertEquals(0, statut(preparer(java("", "--image=a.png", "--taille=4x4", "scenes/s.ini")).directory(variante.toFile())), erreur());
        assertTrue(Files.exists(variante.resolve("a.png")));

        // celle d'ici passe avant
        Files.createDirectories(variante.resolve("scenes"));
        Files.write(variante.resolve("scenes/s.ini"), Arrays.asList("[Cube]"));
        assertEquals(2, statut(preparer(java("", "--image=b.png", "scenes/s.ini")).directory(variante.toFile())));
        assertTrue(erreur().startsWith("lancer : scenes/s.ini, ligne 1, [Cube] : "), erreur());

        // et la scène trouvée plus haut est protégée comme les autres
        Files.delete(variante.resolve("scenes/s.ini"));
        assertEquals(2, statut(preparer(java("", "--image=../scenes/s.ini", "scenes/s.ini")).directory(variante.toFile())));
        assertEquals(2, statut(preparer(java("", "--image=a.png", "ailleurs/s.ini")).directory(variante.toFile())));
    }

    @Test
    void milleRefletsEntreDeuxMiroirsParfaitsTiennentDansLaPile() throws Exception {
        Path scene = dossier.resolve("miroirs.ini");
        Files.write(scene, Arrays.asList(
                "[Sphere devant]", "centre=0 0 1010", "rayon=1000", "Ks=1 1 1",
                "[Sphere derriere]", "centre=0 0 -1000", "rayon=1000", "Ks=1 1 1",
                "[Lampe]", "position=0 3 5", "couleur=1 1 1"));
        assertEquals(0, statut(preparer(java("", "--reflets=1000", "--seuil=0", "--taille=1x1", "--lineaire=a.pfm", "--statistiques",
                scene.toString()))), erreur());
        assertEquals("", erreur());
        for (float composante : Essai.pfm(Files.readAllBytes(dossier.resolve("a.pfm")))) {
            assertTrue(Math.abs(composante) <= Float.MAX_VALUE);
        }
        assertTrue(sortie().contains("rayons.reflechis: 1000\n"), sortie());
    }

    @Test
    void uneImageDuCoursTientDans64Megaoctets() throws Exception {
        List<String> lignes = new ArrayList<>();
        for (int k = 0; k < 10; k++) {
            lignes.addAll(Arrays.asList("[Sphere " + k + "]", "centre=" + (k - 4.5) / 2 + " 0 " + (5 + k % 3), "rayon=0.4", "Kd=0.5 0.5 0.9",
                    "Ks=0.4 0.4 0.4", "ns=30"));
        }
        lignes.addAll(Arrays.asList("[Lampe a]", "position=-4 6 -3", "couleur=1 1 1", "[Lampe b]", "position=4 6 0", "couleur=1 1 1"));
        Path scene = dossier.resolve("dix.ini");
        Files.write(scene, lignes);
        assertEquals(0, statut(preparer(java("-Xmx64m", "--image=a.png", "--lineaire=a.pfm", scene.toString()))), erreur());
        assertEquals("", erreur());
    }

    @Test
    void laMemoireEpuiseeSeDitEnUneLigne() throws Exception {
        assertEquals(1, statut(preparer(java("-Xmx16m", "--image=a.png", "--taille=10000x10000", SCENE))));
        // un terminal sans accents les remplace
        assertTrue(erreur().matches("lancer : m.moire .puis.e ; donner plus . Java, par exemple java -Xmx2g -jar .+\r?\n"), erreur());
        assertFalse(Files.exists(dossier.resolve("a.png")));
    }

    @Test
    void uneGrandeSceneEstLueAuFilAvecPeuDeMemoire() throws Exception {
        supposerUnix();
        byte[] bloc = new byte[1 << 16];
        Arrays.fill(bloc, (byte) 'c');
        for (int k = 0; k < bloc.length; k += 64) {
            bloc[k] = '\n';
            bloc[k + 1] = ';';
        }
        ProcessBuilder p = preparer(java("-Xmx12m", "--image=a.png", "--taille=4x4", "/dev/stdin"));
        processus = p.start();
        try (OutputStream vers = processus.getOutputStream()) {
            vers.write("[Sphere]\ncentre=0 0 6\n".getBytes(StandardCharsets.UTF_8));
            for (int k = 0; k < 640; k++) {
                vers.write(bloc);
            }
            vers.write("\nrayon=1\n".getBytes(StandardCharsets.UTF_8));
        }
        assertEquals(0, processus.waitFor(), erreur());
        assertEquals("", erreur());
    }

    @Test
    void sansLangueLeProgrammeMarcheEtRefuseEnUneLigne() throws Exception {
        Path scene = dossier.resolve("s.ini");
        Files.write(scene, "[Sphère]\n".getBytes(StandardCharsets.UTF_8));
        ProcessBuilder p = preparer(java("", "--image=a.png", scene.toString()));
        Map<String, String> environnement = p.environment();
        environnement.keySet().removeIf(nom -> nom.startsWith("LC_"));
        environnement.put("LANG", "C");
        assertEquals(2, statut(p));
        assertEquals(1, erreur().split("\n").length, erreur());
        assertTrue(erreur().contains("s.ini, ligne 1, [Sph"), erreur());

        Files.write(scene, "[Sphere née à Œx]\ncentre=0 0 6\nrayon=1\n".getBytes(StandardCharsets.UTF_8));
        assertEquals(0, statut(p), erreur());
        assertEquals("", erreur());

        // un nom que cette langue ne sait pas écrire
        p.command(java("", "--image=é.png", scene.toString()));
        int statut = statut(p);
        assertTrue(statut == 0 || statut == 1 && erreur().split("\n").length == 1, statut + " " + erreur());
    }

    @Test
    void laSortieStandardEstUneSortiePermise() throws Exception {
        supposerUnix();
        assertEquals(0, statut(preparer(java("", "--image=a.png", "--lineaire=a.pfm", "--taille=20x15", SCENE))), erreur());
        byte[] png = Files.readAllBytes(dossier.resolve("a.png"));
        for (String nom : new String[] {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
            ProcessBuilder p = preparer(java("", "--image", nom, "--taille=20x15", SCENE));
            processus = p.redirectOutput(ProcessBuilder.Redirect.PIPE).start();
            assertArrayEquals(png, toutLire(processus.getInputStream()), nom);
            assertEquals(0, processus.waitFor(), erreur());
        }
        // vers un fichier, les statistiques suivent l'image
        assertEquals(0, statut(preparer(java("", "--image=/dev/stdout", "--taille=20x15", "--statistiques", SCENE))), erreur());
        byte[] tout = Files.readAllBytes(sortie);
        assertArrayEquals(png, Arrays.copyOf(tout, png.length));
        assertTrue(new String(tout, png.length, tout.length - png.length, StandardCharsets.US_ASCII).startsWith("rayons.primaires: 300\n"));
    }

    private static byte[] toutLire(InputStream entree) throws IOException {
        ByteArrayOutputStream tout = new ByteArrayOutputStream();
        byte[] tampon = new byte[1 << 16];
        for (int n = entree.read(tampon); n >= 0; n = entree.read(tampon)) {
            tout.write(tampon, 0, n);
        }
        return tout.toByteArray();
    }

    @Test
    void uneSortieStandardFermeeOuPleineEstUnePanne() throws Exception {
        assumeTrue(Files.exists(Paths.get("/dev/full")), "pas de /dev/full ici");
        ProcessBuilder p = preparer(java("-Dfile.encoding=UTF-8", "--image=a.png", "--taille=4x4", "--statistiques", SCENE));
        assertEquals(1, statut(p.redirectOutput(new File("/dev/full"))));
        assertEquals(1, erreur().split("\n").length, erreur());
        assertTrue(erreur().startsWith("lancer : sortie standard : "), erreur());
        p = preparer(java("", "--image=/dev/stdout", "--taille=4x4", SCENE));
        assertEquals(1, statut(p.redirectOutput(new File("/dev/full"))));
        assertTrue(erreur().startsWith("lancer : /dev/stdout : "), erreur());
    }

    /** La limite d'un fichier, {@code ulimit -f}, fait comme un disque qui se remplit pendant l'écriture. */
    @Test
    void unDisqueQuiSeRemplitLaisseLAncienneImage() throws Exception {
        supposerUnix();
        Path pfm = dossier.resolve("a.pfm");
        Files.write(pfm, new byte[] {1, 2, 3});
        List<String> commande = new ArrayList<>(Arrays.asList("/bin/sh", "-c", "ulimit -f 64 && exec \"$@\"", "sh"));
        commande.addAll(java("-XX:-UsePerfData -Xshare:off", "--lineaire=a.pfm", "--taille=400x300", SCENE));
        assertEquals(1, statut(preparer(commande)), erreur());
        assertEquals(1, erreur().split("\n").length, erreur());
        assertTrue(erreur().startsWith("lancer : a.pfm : "), erreur());
        assertArrayEquals(new byte[] {1, 2, 3}, Files.readAllBytes(pfm));
        verifierDossier("a.pfm");
    }

    /** Ce qui est dans le dossier, les flux mis à part. */
    private void verifierDossier(String... noms) {
        List<String> presents = new ArrayList<>(Arrays.asList(dossier.toFile().list()));
        presents.remove("flux");
        assertEquals(Arrays.asList(noms), presents);
    }

    @Test
    void ctrlCPendantLeDessinRend130EtNeLaisseRien() throws Exception {
        supposerUnix();
        int pid = demarrerInterruptible(SCENE, "--image=a.png", "--lineaire=a.pfm", "--repeter=100000", "--taille=400x300");
        attendre(() -> tientLesFils(pid));
        interrompre(pid);
        assertEquals(130, processus.waitFor());
        assertEquals("", erreur());
        verifierDossier();
    }

    @Test
    void ctrlCPendantLEcritureNeLaisseRienDInacheve() throws Exception {
        supposerUnix();
        int pid = demarrerInterruptible(Ressources.chemin("valides/vide.ini"), "--lineaire=a.pfm", "--taille=2500x2000");
        attendre(() -> dossier.toFile().list().length > 1 || !processus.isAlive());
        interrompre(pid);
        int statut = processus.waitFor();
        if (statut == 0 || Files.exists(dossier.resolve("a.pfm"))) {
            // l'image était déjà finie
            verifierDossier("a.pfm");
            assertEquals("PF\n2500 2000\n-1.0\n".length() + 12L * 2500 * 2000, Files.size(dossier.resolve("a.pfm")));
        } else {
            assertEquals(130, statut);
            verifierDossier();
        }
    }

    private int demarrerInterruptible(String... arguments) throws Exception {
        List<String> commande = new ArrayList<>(Arrays.asList("/bin/sh", "-c", "echo $$ && exec \"$@\"", "sh"));
        commande.addAll(java("", arguments));
        processus = preparer(commande).start();
        attendre(() -> sortie().endsWith("\n"));
        int pid = Integer.parseInt(sortie().trim());
        for (String ligne : Files.readAllLines(Paths.get("/proc/" + pid + "/status"))) {
            if (ligne.startsWith("SigIgn:")) {
                // un programme lancé en arrière-plan par un script ignore Ctrl+C, et ses enfants aussi
                assumeTrue((Long.parseLong(ligne.substring(7).trim(), 16) & 2) == 0, "Ctrl+C est ignoré ici");
            }
        }
        return pid;
    }

    private static void interrompre(int pid) throws Exception {
        new ProcessBuilder("/bin/sh", "-c", "kill -INT " + pid).start().waitFor();
    }

    /** Vrai quand le dessin a commencé : alors seulement, la machine virtuelle a des fils de ce nom. */
    private static boolean tientLesFils(int pid) throws IOException {
        File[] fils = new File("/proc/" + pid + "/task").listFiles();
        for (File un : fils == null ? new File[0] : fils) {
            try {
                if (Files.readAllLines(un.toPath().resolve("comm")).get(0).startsWith("lancer-1")) {
                    return true;
                }
            } catch (IOException e) {
                // ce fil vient de finir
            }
        }
        return false;
    }

    private interface Condition {
        boolean vraie() throws IOException;
    }

    private static void attendre(Condition condition) throws Exception {
        long fin = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
        while (!condition.vraie()) {
            assertTrue(System.nanoTime() < fin, "attente trop longue");
            Thread.sleep(2);
        }
    }
}
