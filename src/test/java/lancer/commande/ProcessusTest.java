package lancer.commande;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.essai.EssaiProcessus;
import lancer.essai.Ressources;
import lancer.systeme.Console;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Le programme dans sa propre machine virtuelle : mémoire, langue, dossier de travail et flux. */
@Timeout(60)
class ProcessusTest extends EssaiProcessus {

    @Test
    void niAwtNiAutoNeSontChargesSurLeCheminDUnPng() throws Exception {
        assertEquals(0, statut(preparer(java("-verbose:class", "--image", "a.png", "--lineaire", "a.pfm", "--taille=80x60",
                "--statistiques", SCENE))), erreur());
        assertTrue(sortie().contains("lancer.Main "), "les classes chargées ne sont pas dites");
        for (String ligne : sortie().split("\r?\n")) {
            assertFalse(ligne.matches(
                    ".*\\b(java\\.awt|javax\\.swing|sun\\.awt|javax\\.imageio|lancer\\.fenetre|lancer\\.auto)\\b.*"), ligne);
        }
    }

    /** Le dernier chiffre de {@code Math.pow} est le même d'un code interprété et d'un code compilé. */
    @Test
    void interpreteOuCompileUnDessinALesMemesBits() throws Exception {
        for (String machine : new String[] {"-Xint", "-Xcomp"}) {
            assertEquals(0, statut(preparer(java(machine, "--lineaire", machine + ".pfm", "--taille=60x45", SCENE))), erreur());
        }
        assertArrayEquals(Files.readAllBytes(dossier.resolve("-Xint.pfm")), Files.readAllBytes(dossier.resolve("-Xcomp.pfm")));
    }

    /** Java coupe l'adresse d'une ressource au premier « !/ » (JDK-4523159). */
    @Test
    void unJarDansUnDossierQueJavaNeSaitPasLireEstRefuseEnUneLigne() throws Exception {
        Path jar = Files.createDirectories(dossier.resolve("fini !")).resolve("nuit.jar");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(jar))) {
            zip.putNextEntry(new ZipEntry("META-INF/services/lancer.contrat.Variante"));
        }
        List<String> commande = java("", "--image=a.png", SCENE);
        int chemin = commande.indexOf("-cp") + 1;
        commande.set(chemin, commande.get(chemin) + File.pathSeparator + jar);
        assertEquals(2, statut(preparer(commande)));
        assertTrue(erreur().matches("lancer : META-INF/services, .+ ; attendu : .+\\R"), erreur());
    }

    @Test
    void uneSceneRelativeEstChercheeAussiDansLesQuatreDossiersAuDessus() throws Exception {
        // celui que nommerait le message sans lien symbolique
        Path ici = dossier.toRealPath();
        Path variante = Files.createDirectories(ici.resolve("a/b/c/d"));
        Path scenes = Files.createDirectories(ici.resolve("scenes"));
        Files.write(scenes.resolve("s.ini"), List.of("[Sphere]", "centre=0 0 6", "rayon=1"));
        assertEquals(0, statut(preparer(java("", "--image=a.png", "--taille=4x4", "scenes/s.ini")).directory(variante.toFile())), erreur());
        assertTrue(Files.exists(variante.resolve("a.png")));

        // elle est nommée par le chemin où elle est, et protégée comme les autres
        Path haute = Path.of("../../../../scenes/s.png");
        Files.copy(scenes.resolve("s.ini"), scenes.resolve("s.png"));
        refusee(variante, "la sortie est la scène elle-même : " + haute + " ; ", "--image=" + haute, "scenes/s.png");
        // la plus proche passe avant
        for (String ou : List.of("../../../../scenes", "../../scenes", "scenes")) {
            Path proche = Files.createDirectories(variante.resolve(ou)).resolve("s.ini");
            Files.write(proche, List.of("[Cube]"));
            refusee(variante, variante.relativize(proche.normalize()) + ", ligne 1, [Cube] : ", "--image=b.png", "scenes/s.ini");
        }

        // cinq dossiers plus haut, elle n'est pas vue
        Path profond = Files.createDirectory(variante.resolve("e"));
        Files.write(ici.resolve("haut.ini"), new byte[0]);
        refusee(profond, "haut.ini : fichier introuvable dans " + profond + " et les 4 dossiers au-dessus ; attendu : ", "--image=b.png",
                "haut.ini");
        Path racine = Path.of("/").toAbsolutePath();
        refusee(racine, "haut.ini : fichier introuvable dans " + racine + " et ", "--image=b.png", "haut.ini");
    }

    private void refusee(Path ici, String dit, String... arguments) throws Exception {
        assertEquals(2, statut(preparer(java("", arguments)).directory(ici.toFile())));
        assertTrue(erreur().startsWith("lancer : " + dit), erreur());
    }

    @Test
    void uneImageDuCoursTientDans64Megaoctets() throws Exception {
        List<String> lignes = new ArrayList<>();
        for (int k = 0; k < 10; k++) {
            lignes.addAll(List.of("[Sphere " + k + "]", "centre=" + (k - 4.5) / 2 + " 0 " + (5 + k % 3), "rayon=0.4",
                    "Kd=0.5 0.5 0.9", "Ks=0.4 0.4 0.4", "ns=30"));
        }
        lignes.addAll(List.of("[Lampe a]", "position=-4 6 -3", "couleur=1 1 1", "[Lampe b]", "position=4 6 0", "couleur=1 1 1"));
        Path scene = Files.write(dossier.resolve("dix.ini"), lignes);
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
        // celle de Windows ne se choisit pas par LANG
        supposerUnix();
        Path scene = Files.writeString(dossier.resolve("s.ini"), "[Sphère]\n");
        ProcessBuilder p = preparer(sansAccents(java("", "--image=a.png", scene.toString())));
        Map<String, String> environnement = p.environment();
        environnement.keySet().removeIf(nom -> nom.startsWith("LC_"));
        environnement.put("LANG", "C");
        assertEquals(2, statut(p));
        assertEquals(1, erreur().split("\n").length, erreur());
        assertTrue(erreur().contains("s.ini, ligne 1, [Sphère] : "), erreur());

        Files.writeString(scene, "[Sphere née à Œx]\ncentre=0 0 6\nrayon=1\n");
        assertEquals(0, statut(p), erreur());
        assertEquals("", erreur());
    }

    /** Windows ou un vieux terminal ont un codage à eux, qui a des accents : c'est lui qu'ils savent montrer. */
    @Test
    void unFluxNePasseEnUtf8QueLaOuSonCodageNAPasDAccents() throws Exception {
        ByteArrayOutputStream ecrit = new ByteArrayOutputStream();
        for (String codage : new String[] {"ISO-8859-1", "IBM850", "UTF-8", "US-ASCII"}) {
            System.setProperty("essai.encoding", codage);
            PrintStream flux = new PrintStream(ecrit, true, codage);
            assertEquals(codage.equals("US-ASCII"), Console.avecAccents(flux, "essai.encoding") != flux, codage);
        }
        Console.avecAccents(new PrintStream(ecrit, true, "US-ASCII"), "essai.encoding").print("« déjà »");
        assertEquals("« déjà »", ecrit.toString("UTF-8"));
        System.clearProperty("essai.encoding");
    }

    @Test
    void laBarreTientDansLeTerminal() throws Exception {
        supposerUnix();
        assumeTrue(new File("/usr/bin/script").canExecute(), "il faut script pour avoir un terminal");
        StringBuilder dessin = new StringBuilder("exec");
        for (String mot : java("", "--image=a.png", "--repeter=100000", SCENE)) {
            dessin.append(" '").append(mot.replace("'", "'\\''")).append('\'');
        }
        Files.writeString(dossier.resolve("dessin.sh"), dessin.toString());
        for (int[] cas : new int[][] {{30, 20}, {100, 20}}) {
            String commande = "stty cols " + cas[0] + "; sh dessin.sh";
            processus = preparer(List.of("script", "-qefc", commande, "/dev/null")).start();
            attendre(() -> sortie().contains(" %\r"));
            processus.destroy();
            processus.waitFor();
            assertTrue(sortie().matches("(\\r\\[[#.]{" + cas[1] + "}] \\d+ %)+(?s).*"), sortie());
        }
    }

    /** Le nom demandé, ou celui du dossier d'où il l'est : les octets viennent de printf, que ce test ne saurait peut-être pas passer. */
    @Test
    void unNomQueLaLangueDuSystemeNeSaitPasLireDitPourquoiEtLeRemede() throws Exception {
        supposerUnix();
        Files.copy(Path.of(SCENE), dossier.resolve("s.ini"));
        String accent = "$(printf '\\303\\251')";
        String[][] demandes = {{"2", "exec \"$@\" --image=a.png " + accent + ".ini"}, {"1", "exec \"$@\" --image=" + accent + ".png s.ini"},
            {"2", "mkdir " + accent + "; cp s.ini " + accent + "; cd " + accent + "; exec \"$@\" --image=a.png s.ini"},
            {"1", "cd " + accent + "; exec \"$@\" --image=a.png \"$OLDPWD/s.ini\""},
            {"2", "exec \"$@\" --comparer=" + accent + ".png s.ini"}};
        for (String[] demande : demandes) {
            List<String> commande = sansAccents(java(""));
            commande.addAll(0, List.of("/bin/sh", "-c", "export LC_ALL=C; " + demande[1], "sh"));
            assertEquals(demande[0], String.valueOf(statut(preparer(commande))), erreur());
            assertTrue(erreur().matches("lancer : .+ : .+ \\(la langue du syst.me, r.gl.e sur ANSI_X3.4-1968, ne permet pas de lire "
                    + "ce nom : mettre LC_ALL=C.UTF-8 devant la commande\\)( ; attendu : .+)?\n"), erreur());
        }
        assertEquals(3, dossier.toFile().list().length, "la scène, le dossier accentué, les flux");
    }

    @Test
    void unTubeAuBoutDUnLienEstUneSortiePermise() throws Exception {
        supposerUnix();
        assertEquals(0, statut(preparer(java("", "--image=a.png", "--lineaire=a.pfm", "--taille=20x15", SCENE))), erreur());
        for (String fin : new String[] {"png", "pfm"}) {
            Files.createSymbolicLink(dossier.resolve("tube." + fin), Path.of("/dev/stdout"));
            String option = fin.equals("png") ? "--image" : "--lineaire";
            ProcessBuilder p = preparer(java("", option, "tube." + fin, "--taille=20x15", SCENE));
            processus = p.redirectOutput(ProcessBuilder.Redirect.PIPE).start();
            assertArrayEquals(Files.readAllBytes(dossier.resolve("a." + fin)), processus.getInputStream().readAllBytes(), fin);
            assertEquals(0, processus.waitFor(), erreur());
            Files.delete(dossier.resolve("tube." + fin));
        }
    }

    /** Douze millions d'octets par million de pixels, et non seize : cette image ne tiendrait pas avec les codes d'un PNG. */
    @Test
    void lesCouleursNonLimiteesSeulesNeCoutentQueLeurPlace() throws Exception {
        String vide = Ressources.chemin("valides/vide.ini");
        assertEquals(0, statut(preparer(java("-XX:+UseG1GC -Xmx88m", "--lineaire=a.pfm", "--taille=3000x2000", vide))), erreur());
        assertEquals("", erreur());
        assertEquals("PF\n3000 2000\n-1.0\n".length() + 12L * 3000 * 2000, Files.size(dossier.resolve("a.pfm")));
    }
}
