package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lancer.Main;
import org.ini4j.spi.IniParser;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** De quoi lancer le programme dans sa propre machine virtuelle, et voir ce qu'il en reste. */
public abstract class EssaiProcessus {

    protected static final String SCENE = Ressources.chemin("reference/p3-miroirs.ini");

    /** Compiler moins fait gagner du temps sur des programmes d'une demi-seconde. */
    private static final String[] RAPIDE = {"-XX:TieredStopAtLevel=1", "-Xshare:auto"};

    @TempDir
    protected Path dossier;
    private Path erreur;
    protected Path sortie;
    protected Process processus;

    @BeforeEach
    protected void nommerLesFlux() throws IOException {
        Path flux = Files.createDirectory(dossier.resolve("flux"));
        erreur = flux.resolve("erreur");
        sortie = flux.resolve("sortie");
    }

    @AfterEach
    protected void neLaisserAucunProcessus() {
        if (processus != null) {
            processus.destroyForcibly();
        }
    }

    /** La commande qui lance le programme, avec ces options de Java. */
    protected static List<String> java(String options, String... arguments) {
        List<String> commande = new ArrayList<>();
        commande.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        commande.addAll(List.of(RAPIDE));
        commande.addAll(List.of(options.isEmpty() ? new String[0] : options.split(" ")));
        commande.add("-cp");
        commande.add(Essai.origine(Main.class) + File.pathSeparator + Essai.origine(IniParser.class));
        commande.add("lancer.Main");
        commande.addAll(List.of(arguments));
        return commande;
    }

    /** Cette commande, sur des copies : sans langue, Java ne saurait pas lire un chemin de classes qui a un accent. */
    protected List<String> sansAccents(List<String> commande) throws IOException {
        List<String> copies = new ArrayList<>();
        int k = commande.indexOf("-cp") + 1;
        for (String chemin : commande.get(k).split(File.pathSeparator)) {
            Path copie = erreur.resolveSibling("chemin" + copies.size());
            if (Files.notExists(copie)) {
                copier(Path.of(chemin), copie);
            }
            copies.add(copie.toString());
        }
        commande.set(k, String.join(File.pathSeparator, copies));
        return commande;
    }

    private static void copier(Path source, Path copie) throws IOException {
        try (Stream<Path> fichiers = Files.walk(source)) {
            for (Path fichier : (Iterable<Path>) fichiers::iterator) {
                Files.copy(fichier, copie.resolve(source.relativize(fichier).toString()));
            }
        }
    }

    /** Cette commande, dans le dossier du test, ses flux dans des fichiers. */
    protected ProcessBuilder preparer(List<String> commande) {
        ProcessBuilder p = new ProcessBuilder(commande).directory(dossier.toFile());
        // ces variables font écrire à la machine virtuelle une ligne de plus
        p.environment().keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS", "JDK_JAVA_OPTIONS"));
        return p.redirectError(erreur.toFile()).redirectOutput(sortie.toFile());
    }

    protected int statut(ProcessBuilder p) throws IOException, InterruptedException {
        processus = p.start();
        return processus.waitFor();
    }

    protected String erreur() throws IOException {
        String dit = new String(Files.readAllBytes(erreur), StandardCharsets.UTF_8);
        Essai.exigerLaRecherche(dit);
        return dit;
    }

    protected String sortie() throws IOException {
        return new String(Files.readAllBytes(sortie), StandardCharsets.UTF_8);
    }

    protected static void supposerUnix() {
        assumeTrue(File.separatorChar == '/' && Files.exists(Path.of("/proc/self/status")), "pas un Linux");
    }

    /** Ce qui est dans le dossier, les flux mis à part. */
    protected void verifierDossier(String... noms) {
        Set<String> presents = new TreeSet<>(List.of(dossier.toFile().list()));
        presents.remove("flux");
        assertEquals(new TreeSet<>(List.of(noms)), presents);
    }

    protected int demarrerInterruptible(String... arguments) throws Exception {
        List<String> commande = java("", arguments);
        commande.addAll(0, List.of("/bin/sh", "-c", "echo $$ && exec \"$@\"", "sh"));
        processus = preparer(commande).start();
        attendre(() -> sortie().endsWith("\n"));
        int pid = Integer.parseInt(sortie().trim());
        for (String ligne : Files.readAllLines(Path.of("/proc/" + pid + "/status"))) {
            if (ligne.startsWith("SigIgn:")) {
                // un programme lancé en arrière-plan par un script ignore Ctrl+C, et ses enfants aussi
                assumeTrue((Long.parseLong(ligne.substring(7).trim(), 16) & 2) == 0, "Ctrl+C est ignoré ici");
            }
        }
        return pid;
    }

    /** Vrai quand le dessin a commencé : alors seulement, la machine virtuelle a des fils de ce nom. */
    protected static boolean tientLesFils(int pid) throws IOException {
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

    /** Ctrl+C dès que ce programme tient son travail : statut 130, sans message ni fichier. */
    protected void verifierCtrlC(String... arguments) throws Exception {
        supposerUnix();
        int pid = demarrerInterruptible(arguments);
        attendre(() -> tientLesFils(pid));
        interrompre(pid);
        assertEquals(130, processus.waitFor());
        assertEquals("", erreur());
        verifierDossier();
    }

    protected static void interrompre(int pid) throws Exception {
        new ProcessBuilder("/bin/sh", "-c", "kill -INT " + pid).start().waitFor();
    }

    protected static void attendre(Callable<Boolean> condition) throws Exception {
        long fin = System.nanoTime() + TimeUnit.SECONDS.toNanos(100);
        while (!condition.call()) {
            assertTrue(System.nanoTime() < fin, "attente trop longue");
            Thread.sleep(2);
        }
    }
}
