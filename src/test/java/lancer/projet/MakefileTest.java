package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import lancer.essai.EssaiProcessus;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Ce que make décide avant de lancer quoi que ce soit. */
class MakefileTest extends EssaiProcessus {

    private static final String COMMUN = "commun.mk";

    @BeforeEach
    void exigerMake() {
        assumeTrue(new File("/usr/bin/make").canExecute(), "pas de make ici");
    }

    /** Make, par ce fichier du projet ou cette copie, sans rien de ce que lui dit celui qui lance ce test. */
    private ProcessBuilder make(String fichier, String... arguments) {
        List<String> commande = new ArrayList<>(List.of("make", "-s", "-I", new File("").getAbsolutePath(), "-f", fichier));
        commande.addAll(List.of(arguments));
        ProcessBuilder make = preparer(commande);
        make.environment().keySet().removeAll(List.of("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "JAVA", "JAVA_OPTIONS", "LC_ALL",
                "LC_CTYPE", "LANG"));
        if (!new File(fichier).isAbsolute()) {
            make.directory(new File("").getAbsoluteFile());
        }
        return make;
    }

    /** Une copie de commun.mk dans le dossier du test, qui est alors celui du projet. */
    private String copie() throws IOException {
        Path copie = dossier.resolve(COMMUN);
        if (!Files.exists(copie)) {
            Files.copy(Path.of(COMMUN), copie);
        }
        return copie.toString();
    }

    /** Ce qu'il dit, et qui réussit. */
    private String dire(ProcessBuilder commande) throws IOException, InterruptedException {
        assertEquals(0, statut(commande), erreur());
        return sortie().trim();
    }

    /** Ce que vaut LC_ALL pour les commandes de make, lancé avec ces variables. */
    private String langue(String... variables) throws IOException, InterruptedException {
        ProcessBuilder make = make(COMMUN, "--eval", "langue:;@echo $$LC_ALL", "langue");
        for (String variable : variables) {
            make.environment().put(variable.split("=")[0], variable.split("=")[1]);
        }
        return dire(make);
    }

    @Test
    void laLangueEstChangeeLaOuLaMachineNEstPasEnUtf8QuoiQueDisentLesVariables() throws Exception {
        assertEquals("", langue("LANG=C.UTF-8"), "rien à changer : c'est de l'UTF-8");
        assertEquals("C.UTF-8", langue("LC_ALL=C.UTF-8", "LC_CTYPE=C", "LANG=C"));
        assertEquals("C.UTF-8", langue());
        assertEquals("C.UTF-8", langue("LC_CTYPE=C", "LANG=C.UTF-8"), "LC_CTYPE l'emporte sur LANG");
        assertEquals("C.UTF-8", langue("LC_ALL=POSIX", "LC_CTYPE=C.UTF-8", "LANG=C.UTF-8"), "LC_ALL l'emporte sur tout");
        assertEquals("C.UTF-8", langue("LANG=xx_YY.UTF-8"), "cette machine n'a pas cette langue");
    }

    /** La scène que montre make dans le dossier de cette variante, ou à la racine. */
    private String scene(String variante) throws IOException, InterruptedException {
        return dire(make(COMMUN, "VARIANTE=" + variante, "--eval", "scene:;@echo $(SCENE)", "scene"));
    }

    @Test
    void uneVarianteMontreLaSceneQuiPorteSonNomOuCelleDuCours() throws Exception {
        assertEquals("scenes/brume.ini", scene("brume"));
        assertEquals("scenes/scene1.ini", scene("blinn"));
        assertEquals("scenes/scene1.ini", scene(""));
    }

    /** Le vrai lanceur, sans UTF-8, ne saurait lire le chemin d'un dossier accentué. */
    @Test
    void lApplicationDonneUneLangueAuLanceurQuiEnManque() throws Exception {
        supposerUnix();
        Path bin = Files.createDirectories(dossier.resolve("mon dossier"));
        Files.copy(Path.of("outils/lancer.sh"), bin.resolve("lancer"));
        Files.writeString(bin.resolve("lanceur"), "#!/bin/sh\necho \"$LC_ALL : $2\"\n");
        assertTrue(bin.resolve("lanceur").toFile().setExecutable(true));
        Files.createSymbolicLink(dossier.resolve("lien"), bin.resolve("lancer"));
        for (String langue : new String[] {"C", "xx_YY.UTF-8"}) {
            ProcessBuilder lancer = preparer(List.of("sh", "lien", "--image", "a b.png"));
            lancer.environment().put("LC_ALL", langue);
            assertEquals(0, statut(lancer), erreur());
            assertEquals("C.UTF-8 : a b.png\n", sortie());
        }
    }

    /** Eclipse lit un dossier et les modules que nomme son pom.xml, sans chercher plus loin ; Maven et IntelliJ, ensemble.xml. */
    @Test
    void tousLesModulesSImportentEnsemble() throws Exception {
        for (String pom : new String[] {"ensemble.xml", "pom.xml"}) {
            String texte = Files.readString(Path.of(pom));
            for (String module : new String[] {"brume", "blinn", "antialias", "mesures", "correction"}) {
                assertTrue(texte.contains("<module>" + module + "</module>"), pom + ", " + module);
            }
        }
    }

    @Test
    void unCloneDeWindowsALesMemesFinsDeLigne() throws Exception {
        assumeTrue(new File(".git").exists(), "pas un clone");
        List<String> git = List.of("git", "-c", "core.autocrlf=true", "-c", "safe.directory=*");
        String clone = dossier.resolve("clone").toString();
        for (List<String> suite : List.of(List.of("clone", "-q", new File("").getAbsolutePath(), clone),
                List.of("-C", clone, "ls-files", "--eol"))) {
            List<String> commande = new ArrayList<>(git);
            commande.addAll(suite);
            assertEquals(0, statut(preparer(commande)), erreur());
        }
        assertTrue(sortie().contains("README.md"), sortie());
        // seules des scènes fautives exprès ont d'autres fins de ligne, les mêmes dans le dépôt et dans le clone
        for (String fichier : sortie().split("\n")) {
            String[] deux = fichier.trim().split("\\s+");
            assertEquals(deux[0].substring(2), deux[1].substring(2), fichier);
        }
    }

    @Test
    void laOuRienNePeutSEcrireUneLigneDitQueFaire() throws Exception {
        // à la place d'un dossier en lecture seule, où root écrirait
        Files.write(dossier.resolve("target"), new byte[1]);
        assertEquals(2, statut(make(copie(), "target/lancer.jar")));
        assertTrue(erreur().matches("Tout se construit dans .*/target, où rien ne peut s'écrire : copier le projet .*\nmake: .*\n"),
                erreur());
    }

    /** Make demande-t-il le jar à Maven ? */
    private boolean jarRefait() throws IOException, InterruptedException {
        return dire(make(copie(), "MVN=sh maven", "target/lancer.jar")).startsWith("Construction de target/lancer.jar");
    }

    @Test
    void deuxJarsDemandesALaFoisSeConstruisentLUnApresLAutre() throws Exception {
        Files.writeString(dossier.resolve("maven"), "mkdir verrou && sleep 0.3 && rmdir verrou && mkdir -p b/target c/target");
        assertEquals("", dire(make(copie(), "-j8", "MVN=sh maven", "VARIANTES=b c", "JAVA=true", "DISPLAY=:0")).replaceAll(
                "Construction de .*\n?", ""));
    }

    private static void dater(Path fichier, int secondes) throws IOException {
        Files.setLastModifiedTime(fichier, FileTime.from(Instant.parse("2026-01-01T00:00:00Z").plusSeconds(secondes)));
    }

    @Test
    void leJarEstRefaitLaOuUneSourceEstNeuveChangeeOuEffaceeQuelQueSoitSonNom() throws Exception {
        Path pom = Files.write(dossier.resolve("pom.xml"), new byte[1]);
        Path sources = Files.createDirectories(dossier.resolve("src/main/java"));
        Path copie = Files.write(sources.resolve("Sphere - Copie.java"), new byte[1]);
        Files.createSymbolicLink(sources.resolve(".#Sphere.java"), Path.of("emacs@ici:1"));
        Path jar = dossier.resolve("target/lancer.jar");
        Files.createDirectories(jar.getParent());
        Files.writeString(dossier.resolve("maven"), ("touch " + jar));
        assertTrue(jarRefait(), "pas de jar");
        for (Path fichier : List.of(pom, copie, sources, sources.getParent())) {
            dater(fichier, 0);
        }
        assertFalse(jarRefait(), "rien n'a changé");
        dater(jar, 1);
        dater(copie, 2);
        assertTrue(jarRefait(), "une source changée");
        dater(copie, 0);
        dater(jar, 1);
        Files.delete(copie);
        assertTrue(jarRefait(), "une source de moins");
        assertFalse(jarRefait(), "le jar est à jour");
    }
}
