package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import lancer.correction.enfant.Texte;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/** Ce que des noms hostiles ne font pas, et ce que la documentation dit de la défense. */
@EnabledForJreRange(min = JRE.JAVA_17)
class NomsTest extends ClasseEssai {

    private static final Path DOCUMENT = Path.of("..", "docs", "confinement.md");
    private static final List<String> NOMS = List.of("x".repeat(252), "\u001b[2K\rcorrection : 9/9 forge\ncorrection : 9/9 forge : 20",
            "a;=cmd|' C calc'!A0;b", "é".repeat(20_000) + "_11_assignsubmission_file");

    @TempDir
    Path dossier;

    @Test
    void aucunNomNePerdLaClasseNeForgeDeLigneNiDeFormule() throws IOException {
        Path archive = dossier.resolve("classe.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(archive))) {
            for (String nom : NOMS) {
                zip.putNextEntry(new ZipEntry(nom + "/lisez-moi.txt"));
                zip.putNextEntry(new ZipEntry(nom + "/lancer/Vecteur.7z"));
            }
        }
        Path feuille = dossier.resolve("notes.csv");
        Files.writeString(feuille, "Identifiant,Note,Note maximale,Dernière modification (note)\nParticipant11,,20.00,-\n");
        Path pages = dossier.resolve("pages");
        Essai essai = executer("--sans-confinement", "--sortie", pages, "--notes", feuille, archive);
        assertEquals(0, essai.code, essai.erreur);
        String[] lignes = essai.erreur.split("\n");
        assertEquals(1 + NOMS.size(), lignes.length, "une ligne chacun : " + essai.erreur);
        for (String ligne : lignes) {
            assertTrue(ligne.matches("correction : (\\d/4 .*|4 entrées, 4 lignes .*)") && !Texte.NUISIBLES.matcher(ligne).find(), ligne);
        }
        assertEquals(NOMS.size(), pages.resolve("etudiants").toFile().list((d, nom) -> nom.matches("[A-Za-z0-9.%_~-]{6,210}")).length);
        assertFalse(Files.readString(pages.resolve("classe.csv")).matches("(?s).*;\\s*=.*"));
        try (ZipFile zip = new ZipFile(pages.resolve("retours.zip").toFile())) {
            String nom = zip.entries().nextElement().getName();
            assertTrue(nom.endsWith("_11_assignsubmission_file/correction.html"), nom);
            assertTrue(nom.split("/")[0].getBytes(StandardCharsets.UTF_8).length <= 255, nom);
        }
        // un rendu illisible n'a pas zéro, mais rien
        Map<String, String> ligne = classe(pages).get("11");
        assertEquals(List.of("", "", "", ""), List.of(ligne.get("note"), ligne.get("étape atteinte"), ligne.get("sphere"),
                ligne.get("image identique")));
        contient(ligne.get("refus"), "Vecteur.7z : à déplier à la main");
        contient(Files.readString(pages.resolve("index.html")), "4 entrées, 4 lignes",
                "</a><td class=\"n\">sans note<td class=\"petit\"><div>");
    }

    /** Ce que dit le programme, sans confinement permis, si bwrap est le programme de ce dossier. */
    private String sansConfinement(Path bwrap) throws IOException, InterruptedException {
        Path rendu = Files.createDirectories(dossier.resolve("rendu/src/lancer"));
        Files.writeString(rendu.resolve("Vecteur.java"), "package lancer; class Vecteur { }");
        ProcessBuilder programme = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), "-Dfile.encoding=UTF-8", Correction.class.getName(), "--sortie",
                dossier.resolve("pages").toString(), dossier.resolve("rendu").toString());
        programme.environment().put("PATH", bwrap.toString());
        Process lance = programme.redirectErrorStream(true).redirectOutput(dossier.resolve("dit").toFile()).start();
        assertTrue(lance.waitFor(2, TimeUnit.MINUTES));
        assertEquals(1, lance.exitValue());
        List<String> dit = Files.readAllLines(dossier.resolve("dit"));
        assertEquals(1, dit.size(), dit.toString());
        return dit.get(0);
    }

    @Test
    void sansBwrapRienNeSExecuteEtCeQuIlFautTaperEstDit() throws IOException, InterruptedException {
        contient(sansConfinement(dossier), "rien n'a été exécuté : bwrap n'", "un conteneur (docs/confinement.md)",
                "SANS_CONFINEMENT=1 (--sans-confinement)");
        contient(Files.readString(DOCUMENT), "Sans `bwrap` (Windows, Mac), rien n'est exécuté et le statut est 1",
                "`SANS_CONFINEMENT=1`", "make profil-bwrap");
    }

    @Test
    void siAppArmorRefuseLeRemedeEstDitAvantDExecuterSansConfinement() throws IOException, InterruptedException {
        Path bwrap = Files.createDirectories(dossier.resolve("bin")).resolve("bwrap");
        Files.writeString(bwrap, "#!/bin/sh\necho 'bwrap: setting up uid map: Permission denied' >&2\nexit 1\n");
        assertTrue(bwrap.toFile().setExecutable(true));
        String dit = sansConfinement(bwrap.getParent());
        assertTrue(dit.matches(".*AppArmor.*make profil-bwrap.*conteneur.*SANS_CONFINEMENT=1.*"), dit);
        Essai profil = executer("--profil-bwrap");
        assertEquals(0, profil.code);
        contient(profil.sortie, "profile bwrap /usr/bin/bwrap flags=(unconfined) {\n  userns,\n", "/etc/apparmor.d/bwrap");
    }
}
