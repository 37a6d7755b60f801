package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.correction.ClasseEssai;
import lancer.correction.Panne;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce que Moodle donne, et ce que les étudiants y mettent. */
class DepotTest {

    private static final String CLASSE = "package lancer;\npublic class Vecteur extends Tuple {\n}\n";

    @TempDir
    Path dossier;
    Path rendus;
    Path travail;

    @BeforeEach
    void preparer() throws IOException {
        rendus = Files.createDirectories(dossier.resolve("rendus"));
        travail = Files.createDirectories(dossier.resolve("travail"));
    }

    private static void ecrire(Path fichier, String texte) throws IOException {
        Files.createDirectories(fichier.getParent());
        Files.write(fichier, texte.getBytes(StandardCharsets.UTF_8));
    }

    private Map<String, Rendu> lire(Path lieu) {
        return Depot.lire(lieu, travail).stream().collect(Collectors.toMap(r -> r.id, r -> r));
    }

    private static Projet projet(Rendu rendu) {
        return Projet.copies(rendu).get(0);
    }

    private static void verifier(Rendu rendu, String nom) {
        assertEquals(nom, rendu.nom);
        assertEquals(List.of(), rendu.refus);
        assertEquals("lancer/Vecteur", String.join(" ", projet(rendu).base.keySet()));
    }

    @Test
    void lesDeuxFormesDeDossiersDeMoodleEtLesFichiersAPlatSeLisent() throws IOException {
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/src/main/java/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Étudiant 1_12_assignsubmission_file_/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Participant_13_assignsubmission_file_Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Étudiant 3_14_assignsubmission_onlinetext/onlinetext.html"), "bonjour");
        Map<String, Rendu> lus = lire(rendus);
        assertEquals(new TreeSet<>(List.of("11", "12", "13", "14")), new TreeSet<>(lus.keySet()));
        verifier(lus.get("11"), "Étudiant 1");
        verifier(lus.get("12"), "Étudiant 1");
        verifier(lus.get("13"), "Participant");
        assertEquals(List.of("aucun fichier .java dans ce rendu"), lus.get("14").refus);
    }

    @Test
    void lArchiveDeMoodleEtLesArchivesQuElleContientSeLisent() throws IOException {
        Path projet = dossier.resolve("projet");
        ecrire(projet.resolve("src/main/java/lancer/Vecteur.java"), CLASSE);
        ecrire(projet.resolve("__MACOSX/src/._Vecteur.java"), "x");
        ecrire(projet.resolve(".idea/Autre.java"), "x");
        ecrire(projet.resolve("target/classes/Autre.java"), "x");
        Path tout = dossier.resolve("tout");
        Path un = Files.createDirectories(tout.resolve("Étudiant 1_11_assignsubmission_file"));
        ClasseEssai.archiver(projet, un.resolve("TP.zip"), "TP1/");
        Files.createDirectories(tout.resolve("Étudiant 2_12_assignsubmission_file"));
        ClasseEssai.archiver(projet, tout.resolve("Étudiant 2_12_assignsubmission_file/emboite.zip"), "");
        ClasseEssai.archiver(tout.resolve("Étudiant 2_12_assignsubmission_file"),
                tout.resolve("Étudiant 3_13_assignsubmission_file_deux.zip"), "x/");
        Path moodle = dossier.resolve("moodle.zip");
        ClasseEssai.archiver(tout, moodle, "");
        Map<String, Rendu> lus = lire(moodle);
        verifier(lus.get("11"), "Étudiant 1");
        verifier(lus.get("12"), "Étudiant 2");
        verifier(lus.get("13"), "Étudiant 3");
        assertEquals(3, lus.size());
        assertEquals(new TreeSet<>(List.of("11", "12", "13")), new TreeSet<>(lire(tout).keySet()), "déplié, c'est pareil");
    }

    @Test
    void unDossierEtUneArchiveDeMemeNomSontDeuxRendus() throws IOException {
        ecrire(rendus.resolve("dupont/lancer/Vecteur.java"), CLASSE);
        ClasseEssai.archiver(rendus.resolve("dupont"), rendus.resolve("dupont.zip"), "");
        Map<String, Rendu> lus = lire(rendus);
        verifier(lus.get("dupont"), "dupont");
        verifier(lus.get("dupont.zip"), "dupont.zip");
    }

    @Test
    void desArchivesNommeesCommeLeProjetSontAutantDeRendus() throws IOException {
        Path projet = dossier.resolve("projet");
        ecrire(projet.resolve("src/main/java/lancer/Vecteur.java"), CLASSE);
        Files.createDirectories(rendus);
        for (String nom : List.of("lancer-base-dupont.zip", "lancer-base-martin.zip", "TP durand.zip")) {
            ClasseEssai.archiver(projet, rendus.resolve(nom), "");
        }
        assertEquals(3, lire(rendus).size());
    }

    @Test
    void unSeulRenduEstUneClasseDUn() throws IOException {
        ecrire(rendus.resolve("src/main/java/lancer/Vecteur.java"), CLASSE);
        verifier(lire(rendus).get("rendus"), "rendus");
        Path zip = dossier.resolve("TP de moi.zip");
        ClasseEssai.archiver(rendus, zip, "lancer-base/");
        verifier(lire(zip).get("TP de moi"), "TP de moi");
    }

    @Test
    void ceQuiEstRefuseEstNommeEtLaLigneReste() throws IOException {
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/tp.rar"), "Rar!");
        ecrire(rendus.resolve("Étudiant 2_12_assignsubmission_file/tp.7z"), "7z");
        ecrire(rendus.resolve("Étudiant 3_13_assignsubmission_file/tp.zip"), "ceci n'est pas une archive");
        Files.createDirectories(rendus.resolve("Étudiant 4_14_assignsubmission_file"));
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(
                rendus.resolve("Étudiant 4_14_assignsubmission_file/tp.zip")))) {
            zip.putNextEntry(new ZipEntry("../../evade.java"));
            zip.write(CLASSE.getBytes(StandardCharsets.UTF_8));
        }
        Path gros = Files.createDirectories(rendus.resolve("Étudiant 5_15_assignsubmission_file")).resolve("bombe.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(gros))) {
            zip.putNextEntry(new ZipEntry("lancer/Vecteur.java"));
            zip.write(CLASSE.getBytes(StandardCharsets.UTF_8));
            zip.putNextEntry(new ZipEntry("zeros"));
            byte[] mega = new byte[1 << 20];
            for (int k = 0; k < 60; k++) {
                zip.write(mega);
            }
        }
        Path secret = dossier.resolve("secret.java");
        ecrire(secret, CLASSE);
        Files.createDirectories(rendus.resolve("Étudiant 6_16_assignsubmission_file"));
        Files.createSymbolicLink(rendus.resolve("Étudiant 6_16_assignsubmission_file/Vecteur.java"), secret);
        Path lien = Files.createDirectories(rendus.resolve("Étudiant 7_17_assignsubmission_file")).resolve("lien.zip");
        ecrireLien(lien, "Vecteur.java", secret.toString());
        Map<String, Rendu> lus = lire(rendus);
        assertEquals(7, lus.size());
        refuse(lus.get("11"), "tp.rar : format non pris en charge");
        refuse(lus.get("12"), "tp.7z : format non pris en charge");
        refuse(lus.get("13"), "tp.zip : archive illisible");
        refuse(lus.get("14"), "../../evade.java");
        refuse(lus.get("15"), "plus de 50 Mo");
        refuse(lus.get("16"), "lien refusé : Vecteur.java");
        refuse(lus.get("17"), "lien refusé : Vecteur.java");
    }

    private static void refuse(Rendu rendu, String message) {
        assertTrue(rendu.refus.stream().anyMatch(r -> r.contains(message)), rendu.refus.toString());
        assertEquals(Map.of(), rendu.sources);
    }

    /** Une archive d'un seul lien : ce que fait « zip --symlinks ». Il suffit d'en changer les droits, dans le répertoire central. */
    private static void ecrireLien(Path archive, String nom, String cible) throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(archive))) {
            zip.putNextEntry(new ZipEntry(nom));
            zip.write(cible.getBytes(StandardCharsets.UTF_8));
        }
        ByteBuffer octets = ByteBuffer.wrap(Files.readAllBytes(archive)).order(ByteOrder.LITTLE_ENDIAN);
        int fiche = 0;
        while (octets.getInt(fiche) != 0x02014b50) {
            fiche++;
        }
        octets.put(fiche + 5, (byte) 3);
        octets.putInt(fiche + 38, 0xA1FF << 16);
        try (OutputStream sortie = Files.newOutputStream(archive)) {
            sortie.write(octets.array());
        }
    }

    @Test
    void lesAccentsDAutresCodagesEtUnPaquetOublieSArrangent() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/TP");
        Files.createDirectories(projet);
        Files.write(projet.resolve("Vecteur.java"), "// été\npublic class Vecteur {}\n".getBytes(StandardCharsets.ISO_8859_1));
        ecrire(projet.resolve("Point.java"), "\uFEFFpackage monpaquet;\nimport monpaquet.Vecteur;\nclass Point {}\n");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("package lancer; // été\npublic class Vecteur {}\n", lu.texte("Vecteur"));
        assertEquals("package lancer;\nimport lancer.Vecteur;\nclass Point {}\n", lu.texte("Point"));
        assertEquals(2, lu.remarques.size(), lu.remarques.toString());
    }

    @Test
    void lesVariantesSontDesCopiesAPart() throws IOException {
        for (String partie : List.of("lancer-base", "brume", "Antialias", "blinn")) {
            ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/" + partie + "/src/main/java/lancer/Vecteur.java"), CLASSE);
        }
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer-base/src/test/java/lancer/Tests.java"),
                "package lancer; class Tests {}");
        Projet projet = projet(lire(rendus).get("11"));
        assertEquals(List.of("brume", "antialias", "blinn"), List.copyOf(projet.variantes.keySet()));
        assertEquals(1, projet.base.size(), "Tests, de l'étudiant, n'en est pas");
    }

    @Test
    void desSourcesEnDeuxDossiersSontUnSeulProjetEtUneAncienneVersionEstLaissee() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file");
        for (String classe : List.of("src/Vecteur", "src/Point", "src/Rayon", "src/Camera", "src2/Sphere", "src2/Scene", "src2/Objet3D",
                "vieux/Vecteur", "vieux/Point", "vieux/Rayon")) {
            ecrire(projet.resolve(classe.replace("/", "/lancer/") + ".java"), "package lancer; // " + classe);
        }
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals(7, lu.base.size(), lu.base.keySet().toString());
        assertEquals("package lancer; // src/Vecteur", lu.texte("Vecteur"));
        assertEquals(List.of("plusieurs copies du projet : jugée, « src/ » ; laissée, « vieux/ »"), lu.remarques);
    }

    @Test
    void plusieursClassesDansUnFichierSontAutantDeClassesAuxMemesLignes() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("TP.java"), "import java.util.List; // {\nclass Vecteur { char c = '}';\n static class Point { } }\n"
                + "/** Un point. */ @Deprecated final class Point { }\nenum Outil { A }\n");
        ecrire(projet.resolve("Sphere.java"), "package lancer; class Sphere { } }\n void f() { }\n class Scene { }");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[lancer/Outil, lancer/Point, lancer/Sphere, lancer/Vecteur]", lu.base.keySet().toString(),
                "une accolade de trop ne fait pas deux classes");
        assertEquals("package lancer; import java.util.List; // {\nclass Vecteur { char c = '}';\n static class Point { } }",
                lu.texte("Vecteur"));
        assertEquals("package lancer; import java.util.List;\n\n\n/** Un point. */ @Deprecated final class Point { }",
                lu.texte("Point").replaceAll(" +(?=\n)", ""));
    }

    @Test
    void unTexteDemesureSeLitCommeUnAutre() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("A.java"), "\n".repeat(900_000));
        ecrire(projet.resolve("B.java"), "package lancer; class B { String s = \"" + "ab".repeat(300_000) + "\"; }");
        ecrire(projet.resolve("C.java"), "package lancer; class C { void f() " + "{".repeat(300_000) + "}".repeat(300_000) + " }");
        ecrire(projet.resolve("D.java"), "package lancer; class D { " + "/*".repeat(3) + " /*".repeat(300_000));
        ecrire(projet.resolve("Vecteur.java"), "package lancer; class Vecteur { " + "public ".repeat(100_000) + "}");
        assertEquals(5, projet(lire(rendus).get("11")).base.size());
    }

    @Test
    void ceQuiCacheUneClasseDeJavaEstLaisseDeCoteOuQuIlSoitDansLeFichier() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("A.java"), "package lancer; class A { char c = '{'; String s = \"{ // \"; } /* { */ class Math { }");
        ecrire(projet.resolve("B.java"), "package lancer; class B { static class Math { } String s = \"} class Math\"; }");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[lancer/B]", lu.base.keySet().toString(), "Math n'y est pas");
        assertEquals(List.of("lancer/A.java : laissé de côté, il déclare une classe Math qui cacherait celle de Java"),
                lu.remarques);
    }

    @Test
    void beaucoupDeFichiersEnToutNeSontPasTropPourUneClasse() throws IOException {
        Path moodle = dossier.resolve("moodle.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(moodle))) {
            for (int k = 0; k < 20_001; k++) {
                zip.putNextEntry(new ZipEntry("Étudiant_" + k % 30 + "_assignsubmission_file/.git/" + k));
            }
            zip.putNextEntry(new ZipEntry("Étudiant_7_assignsubmission_file/lancer/Vecteur.java"));
            zip.write(CLASSE.getBytes(StandardCharsets.UTF_8));
        }
        Map<String, Rendu> lus = lire(moodle);
        verifier(lus.get("7"), "Étudiant");
    }

    @Test
    void unAutreOrdreDeParametresEstUneRemarqueEtNonUneFaute() throws IOException {
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Objet3D.java"),
                "package lancer;\nabstract class Objet3D {\n    public Couleur getColor(Rayon r, Scene s, PointContact c, int p) {\n"
                        + "        return null;\n    }\n}\n");
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Scene.java"),
                "package lancer;\nclass Scene {\n    public PointContact getClosestIntersection(Rayon r) {\n        return null;\n    }\n"
                        + "    public PointContact getClosestIntersection(final Rayon r, Objet3D o) {\n        return null;\n    }\n}\n");
        Projet projet = projet(lire(rendus).get("11"));
        assertTrue(projet.texte("Objet3D").contains(
                "getColor(Scene p0, Rayon p1, PointContact p2, int p3) { return getColor(p1, p0, p2, p3); }"));
        assertEquals(1, projet.remarques.size(), projet.remarques.toString());
    }

    @Test
    void unReelDUneAutreSorteEstLaisseTelQuelEtDesEntiersSeLaissentAppeler() throws IOException {
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Lancer.java"), "package lancer;\nclass Lancer {\n"
                + "    public Couleur getCouleurPixel(int xe, int ye, int p) {\n        return null;\n    }\n}\n");
        String vecteur = "package lancer;\nclass Vecteur {\n    public float dot(Vecteur v) {\n        return dot (v);\n    }\n}\n";
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Vecteur.java"), vecteur);
        Projet projet = projet(lire(rendus).get("11"));
        assertTrue(projet.texte("Lancer").contains("getCouleurPixel(double p0, double p1, int p2) { "
                + "return getCouleurPixel((int) p0, (int) p1, p2); }"), projet.texte("Lancer"));
        assertEquals(vecteur, projet.texte("Vecteur"));
        assertEquals(1, projet.remarques.size(), projet.remarques.toString());
    }

    @Test
    void unNomQuiNEstPasCeluiDUneClasseNeFaitPasUnChemin() throws IOException {
        Path archive = Files.createDirectories(rendus.resolve("Étudiant 1_11_assignsubmission_file")).resolve("tp.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(archive))) {
            int k = 0;
            for (String paquet : List.of(".tmp.x.y", "..", "a..b", "a.", "a".repeat(300), "java.lang", "lancer.correction.x")) {
                entree(zip, "p" + k++ + "/Mal.java", "package " + paquet + ";\nclass Mal { }\n");
            }
            for (String nom : List.of("A\nFIN\n.java", "A\tB.java", " .java", ".java", "A\u202Egpj.java", "b".repeat(200) + ".java",
                    "c".repeat(9000) + ".java", "A\u0000.java", "CON .java")) {
                entree(zip, nom, "package x; interface " + "Z" + k++ + " {}");
            }
            entree(zip, "lancer/Vecteur (1).java", CLASSE);
            StringBuilder milliers = new StringBuilder("package lancer;\n");
            for (int n = 0; n < 40_000; n++) {
                milliers.append("class C").append(n).append("{}\n");
            }
            entree(zip, "lancer/Milliers.java", milliers.toString());
            entree(zip, "lancer/Point.java", milliers + "class Point { }\n");
        }
        Rendu rendu = lire(rendus).get("11");
        Projet projet = projet(rendu);
        // ce que déclare un fichier mal nommé le nomme
        assertEquals("lancer/Vecteur", projet.base.keySet().stream().filter(cle -> !cle.matches("x/Z\\d+"))
                .collect(Collectors.joining(" ")));
    }

    private static void entree(ZipOutputStream zip, String nom, String texte) throws IOException {
        zip.putNextEntry(new ZipEntry(nom));
        zip.write(texte.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void desFichiersAuHasardNeFontQueDesNomsDeClassesOuDesRefus() throws IOException {
        Random hasard = new Random(27);
        String[] morceaux = {"package ", "lancer", ".", ";", "\n", " ", "class ", "Vecteur", "{", "}", "/*", "*/", "//", "\"", "'", "\\",
            "é", "\t", "(", ")", "import ", "\uD83D\uDE00", "\u0000", "public ", "double dot(", "interface ", "=", "\r"};
        for (int tour = 0; tour < 300; tour++) {
            StringBuilder texte = new StringBuilder();
            StringBuilder nom = new StringBuilder(hasard.nextBoolean() ? "lancer/" : "");
            for (int k = hasard.nextInt(60); k > 0; k--) {
                texte.append(morceaux[hasard.nextInt(morceaux.length)]);
            }
            for (int k = hasard.nextInt(6); k > 0; k--) {
                nom.append(morceaux[hasard.nextInt(morceaux.length)]);
            }
            byte[] octets = texte.toString().getBytes(hasard.nextBoolean() ? StandardCharsets.UTF_8 : StandardCharsets.UTF_16);
            for (int k = hasard.nextInt(4); k > 0 && octets.length > 0; k--) {
                octets[hasard.nextInt(octets.length)] = (byte) hasard.nextInt();
            }
            Rendu rendu = new Rendu("1", "un");
            rendu.ajouter(nom + ".java", octets);
            projet(rendu).base.keySet().forEach(cle -> assertTrue(cle.matches("(\\w+/)*[\\p{L}_$][\\p{L}\\p{N}_$]*"), cle));
        }
    }

    @Test
    void rienEstRefuseEnUnePhrase() {
        assertEquals(2, Assertions.assertThrows(Panne.class, () -> Depot.lire(dossier.resolve("absent"), travail)).code);
        assertEquals(2, Assertions.assertThrows(Panne.class, () -> Depot.lire(rendus, travail)).code);
    }
}
