package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.correction.ClasseEssai;
import lancer.correction.Panne;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ce que Moodle donne : des dossiers, des archives, et ce qui en est refusé. */
class DepotTest extends DepotEssai {

    @Test
    void lesDeuxFormesDeDossiersDeMoodleEtLesFichiersAPlatSeLisent() throws IOException {
        ecrire(rendu.resolve("src/main/java/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Étudiant 1_12_assignsubmission_file_/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Participant_13_assignsubmission_file_Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Étudiant 3_14_assignsubmission_onlinetext/onlinetext.html"), "bonjour");
        Map<String, Rendu> lus = lire(rendus);
        assertEquals(new TreeSet<>(List.of("11", "12", "13", "14")), new TreeSet<>(lus.keySet()));
        verifier(lus.get("11"), "Étudiant 1");
        verifier(lus.get("12"), "Étudiant 1");
        verifier(lus.get("13"), "Participant");
        assertEquals(List.of("aucun fichier .java dans ce rendu ; il contient : onlinetext.html"), lus.get("14").refus);
    }

    @Test
    void lArchiveDeMoodleEtLesArchivesQuElleContientSeLisent() throws IOException {
        Path projet = dossier.resolve("projet");
        ecrire(projet.resolve("src/main/java/lancer/Vecteur.java"), CLASSE);
        ecrire(projet.resolve("__MACOSX/src/._Vecteur.java"), "x");
        ecrire(projet.resolve(".idea/Autre.java"), "x");
        ecrire(projet.resolve("target/classes/Autre.class"), "x");
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

    /** À gauche, les fichiers d'une classe ; à droite, les lignes, ou « ! » et ce qui n'est le rendu de personne. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "dupont/lancer/Vecteur.java;dupont.zip | dupont;dupont.zip",
        // GitHub Classroom
        "lancer-base-jdupont/src/lancer/A.java;lancer-base-zoe-nguyen/src/lancer/A.java | lancer-base-jdupont;lancer-base-zoe-nguyen",
        "lancer-base-dupont.zip;lancer-base-martin.zip;TP durand.zip | TP durand.zip;lancer-base-dupont.zip;lancer-base-martin.zip",
        "lancer/A.java;brume/A.java;antialias/A.java;blinn.zip;pom/A.java | antialias;blinn.zip;brume;lancer;pom",
        // Canvas, où un étudiant a rendu ses fichiers un à un, et un autre en retard
        "dupontj_12_801_Vecteur.java;dupontj_12_801_Point.java;martinp_LATE_13_802_TP-2.zip;leal_14_803_tp.zip "
            + "| dupontj_12;leal_14;martinp_13",
        "TP1_2026_11_dupont.zip;TP1_2026_11_martin.zip | TP1_2026_11_dupont.zip;TP1_2026_11_martin.zip",
        // un dossier autour de tous : Drive, Nextcloud, Finder, Gradescope
        "TP été/dupont/A.java;TP été/martin.zip;__MACOSX/TP été/._x;TP été/.DS_Store;.git/config | dupont;martin.zip",
        "a/b/c/dupont/A.java;a/b/c/martin/A.java | dupont;martin",
        "Étudiant 1_11_assignsubmission_file/lancer/Vecteur.java | 11",
        "moodle/Zoé_11_assignsubmission_file_A.java;moodle/Zoé_11_assignsubmission_onlinetext/o.html;"
            + "moodle/Éva_12_assignsubmission_file_/A.java | 11;12",
        // rien ne disparaît
        "dupont.zip;rapport.pdf;rapport.docx;tp.jar;sans-fin;martin.rar | dupont.zip;martin.rar;rapport.docx;rapport.pdf;sans-fin;tp.jar",
        "src/lancer/Vecteur.java;pom.xml | !pom.xml", "dupont/src/lancer/Vecteur.java | !Vecteur.java",
        "a.zip;b.zip;c.zip;d.zip;Vecteur.java | Vecteur.java;a.zip;b.zip;c.zip;d.zip",
        // un numéro, ou un nom, qui serait celui de la ligne d'un autre
        "101/lancer/A.java;Alice Martin_101_assignsubmission_file/lancer/A.java | 101;101/"})
    void uneEntreeEstUneLigneQuelQueSoitSonNom(String fichiers, String lignes) throws IOException {
        for (String fichier : fichiers.split(";")) {
            ecrire(rendus.resolve(fichier), "x");
        }
        Path archive = dossier.resolve("la classe.zip");
        ClasseEssai.archiver(rendus, archive, "");
        Path emballee = Files.createDirectories(dossier.resolve("téléchargements")).resolve("tout.zip");
        ClasseEssai.archiver(rendus, emballee, "autour/");
        Path deux = dossier.resolve("deux.zip");
        ClasseEssai.archiver(emballee.getParent(), deux, "");
        for (Path lieu : List.of(rendus, archive, emballee.getParent(), deux)) {
            if (lignes.startsWith("!")) {
                Panne panne = Assertions.assertThrows(Panne.class, () -> classe(lieu));
                assertEquals(2, panne.code);
                assertTrue(panne.getMessage().startsWith("rien n'est jugé : « " + lignes.substring(1) + " »")
                        && panne.getMessage().contains("make corriger UN=" + lieu), panne.getMessage());
            } else {
                assertEquals(lignes, classe(lieu).stream().map(r -> r.id).sorted().collect(Collectors.joining(";")), lieu.toString());
            }
        }
    }

    @Test
    void unRetardDeCanvasEstDitEtSesFichiersNOntPlusSonDebut() throws IOException {
        ecrire(rendus.resolve("dupontj_LATE_12_801_Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("leal_14_803_tp.pdf"), "x");
        Rendu dupont = lire(rendus).get("dupontj_12");
        assertEquals(List.of(List.of("rendu en retard, d'après Canvas"), List.of("Vecteur.java"), "dupontj"),
                List.of(dupont.remarques, List.copyOf(dupont.sources.keySet()), dupont.nom));
    }

    @Test
    void unSeulRenduSeDemande() throws IOException {
        ecrire(rendus.resolve("src/main/java/lancer/Vecteur.java"), CLASSE);
        verifier(un(rendus), "rendus");
        Path zip = dossier.resolve("TP de moi.zip");
        ClasseEssai.archiver(rendus, zip, "lancer-base/");
        assertEquals("TP de moi.zip", un(zip).id);
        Path moodle = dossier.resolve("Zoé_17_assignsubmission_file");
        ClasseEssai.copier(rendus, moodle);
        assertEquals(List.of("17", "Zoé"), List.of(un(moodle).id, un(moodle).nom));
    }

    @Test
    void lesNomsSontDansLOrdreDuFrancais() throws IOException {
        for (String nom : List.of("Zoé", "Éloïse", "Étudiant 10", "Étudiant 2", "eve")) {
            ecrire(rendus.resolve(nom).resolve("lancer/Vecteur.java"), CLASSE);
        }
        assertEquals("[Éloïse, Étudiant 2, Étudiant 10, eve, Zoé]", classe(rendus).stream().map(r -> r.nom).collect(Collectors.toList())
                .toString());
    }

    @Test
    void ceQuiNEstPasLuNeCompteEtUnDossierQuiADesSourcesSeLit() throws IOException {
        ecrire(rendu.resolve("out/lancer/Vecteur.java"), CLASSE);
        ecrire(rendu.resolve("build/lancer/Point.java"), CLASSE);
        ecrire(rendu.resolve("target/classes/lancer/Vecteur.class"), "x");
        try (RandomAccessFile video = new RandomAccessFile(rendu.resolve("film.mp4").toFile(), "rw")) {
            video.setLength(90L << 20);
        }
        Rendu lu = lire(rendus).get("11");
        assertEquals(List.of(List.of(), "[build/lancer/Point.java, out/lancer/Vecteur.java]", "[target]"),
                List.of(lu.refus, lu.sources.keySet().toString(), lu.outils.toString()));
    }

    @Test
    void ceQuiEstRefuseEstNommeEtLaLigneReste() throws IOException {
        ecrire(rendu.resolve("tp.rar"), "Rar!");
        ecrire(rendus.resolve("Étudiant 2_12_assignsubmission_file/tp.7z"), "7z");
        ecrire(rendus.resolve("Étudiant 3_13_assignsubmission_file/tp.zip"), "ceci n'est pas une archive");
        Path evade = Files.createDirectories(rendus.resolve("Étudiant 4_14_assignsubmission_file")).resolve("tp.zip");
        Files.write(evade, zip(Map.of("../../evade.java", octets(CLASSE))));
        Path gros = Files.createDirectories(rendus.resolve("Étudiant 5_15_assignsubmission_file")).resolve("bombe.zip");
        Files.write(gros, zip(Map.of("lancer/Vecteur.java", octets(CLASSE), "zeros.zip", new byte[60 << 20])));
        Path secret = dossier.resolve("secret.java");
        ecrire(secret, CLASSE);
        Files.createDirectories(rendus.resolve("Étudiant 6_16_assignsubmission_file"));
        Files.createSymbolicLink(rendus.resolve("Étudiant 6_16_assignsubmission_file/Vecteur.java"), secret);
        Path lien = Files.createDirectories(rendus.resolve("Étudiant 7_17_assignsubmission_file")).resolve("lien.zip");
        ClasseEssai.ecrireLien(lien, "Vecteur.java", secret.toString());
        Map<String, Rendu> lus = lire(rendus);
        assertEquals(7, lus.size());
        refuse(lus.get("11"), "tp.rar : à déplier à la main ; seuls les dossiers et les .zip le sont ici, dans un dossier de même nom "
                + "que ce rendu : « Étudiant 1_11_assignsubmission_file »");
        refuse(lus.get("12"), "tp.7z : à déplier à la main");
        refuse(lus.get("13"), "tp.zip : archive illisible");
        refuse(lus.get("14"), "../../evade.java");
        refuse(lus.get("15"), "plus de 50 Mo");
        refuse(lus.get("16"), "lien refusé : Vecteur.java");
        refuse(lus.get("17"), "lien refusé : Vecteur.java");
    }

    @Test
    void dUnNomQuiCommenceParUnPointOuParLaRacineResteLeChemin() throws IOException {
        Map<String, byte[]> entrees = new LinkedHashMap<>(Map.of("./", new byte[0], "./Dupont/", new byte[0]));
        for (String nom : List.of("./Dupont/./lancer/Vecteur.java", "/Durand/lancer/Vecteur.java", "C:\\Roux\\lancer\\Vecteur.java")) {
            entrees.put(nom, octets(CLASSE));
        }
        Map<String, Rendu> lus = lire(Files.write(dossier.resolve("classe.zip"), zip(entrees)));
        assertEquals(Set.of("Dupont", "Durand", "Roux"), lus.keySet());
        lus.values().forEach(r -> assertEquals(Set.of("lancer/Vecteur.java"), r.sources.keySet(), r.nom));
        assertEquals(List.of(), lus.get("Dupont").refus);
        assertEquals(List.of("des noms absolus dans l'archive (/…) : lus sans leur racine"), lus.get("Durand").refus);
        assertEquals(List.of("des noms absolus dans l'archive (C:/…) : lus sans leur racine"), lus.get("Roux").refus);
    }

    private static void refuse(Rendu rendu, String message) {
        assertTrue(rendu.refus.stream().anyMatch(r -> r.contains(message)), rendu.refus.toString());
        assertEquals(Map.of(), rendu.sources);
    }

    @Test
    void ceQuiResteADeplierEstARegarderMemeACoteDeSources() throws IOException {
        for (String nom : List.of("tp.7z", "TP.RAR", "tp.tar.gz", "tp.tgz", "tp.7z.001", "tp.zip.002", "tp.tar.zst")) {
            ecrire(rendu.resolve("" + nom), "x");
        }
        ecrire(rendu.resolve("lancer/Vecteur.java"), CLASSE);
        Rendu rendu = lire(rendus).get("11");
        assertEquals(7, rendu.refus.stream().filter(r -> r.contains(" : à déplier à la main")).count(), rendu.refus.toString());
        assertEquals("[lancer/Vecteur]", projet(rendu).base.keySet().toString());
        assertEquals(rendu.refus, projet(rendu).remarques);
    }

    @Test
    void beaucoupDeFichiersEnToutNeSontPasTropPourUneClasse() throws IOException {
        Map<String, byte[]> entrees = new LinkedHashMap<>();
        for (int k = 0; k < 20_001; k++) {
            entrees.put("Étudiant_" + (7 + k % 2) + "_assignsubmission_file/.git/" + k, new byte[0]);
        }
        entrees.put("Étudiant_7_assignsubmission_file/lancer/Vecteur.java", octets(CLASSE));
        verifier(lire(Files.write(dossier.resolve("moodle.zip"), zip(entrees))).get("7"), "Étudiant");
    }

    @Test
    void desFichiersAuHasardNeFontQueDesNomsDeClassesOuDesRefus() throws IOException {
        Random hasard = new Random(27);
        String[] morceaux = {"package ", "lancer", ".", ";", "\n", " ", "class ", "Vecteur", "{", "}", "/*", "*/", "//", "\"", "'", "\\",
            "é", "\t", "(", ")", "import ", "\uD83D\uDE00", "\u0000", "public ", "double dot(", "interface ", "=", "\r"};
        for (int tour = 0; tour < 100; tour++) {
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
            rendu.sources.put(nom + ".java", octets);
            projet(rendu).base.keySet().forEach(cle -> assertTrue(cle.matches("(\\w+/)*[\\p{L}_$][\\p{L}\\p{N}_$]*"), cle));
        }
    }

    private Rendu deposer(String nom, byte[] archive) throws IOException {
        Files.write(Files.createDirectories(rendu).resolve(nom), archive);
        return lire(rendus).get("11");
    }

    /** Ce que 7-Zip sait écrire et que la bibliothèque, seule, ne sait pas lire. */
    @ParameterizedTest
    @CsvSource({"95, XZ", "93, ZSTD", "14, LZMA", "98, PPMD", "177, 177"})
    void uneCompressionQuiNEstPasLueEstNommeeUneFois(int methode, String nom) throws IOException {
        byte[] archive = zip(Map.of("лучи/Vecteur.java", octets(CLASSE), "лучи/Point.java", new byte[9]));
        ByteBuffer octets = ByteBuffer.wrap(archive).order(ByteOrder.LITTLE_ENDIAN);
        for (int k = 0; k < archive.length - 4; k++) {
            int decalage = octets.getInt(k) == 0x04034b50 ? 8 : octets.getInt(k) == 0x02014b50 ? 10 : 0;
            if (decalage > 0) {
                octets.putShort(k + decalage, (short) methode);
            }
        }
        assertEquals(List.of("光线.zip : archive comprimée d'une façon qui n'est pas lue ici (" + nom + ") ; à déplier à la main"),
                deposer("光线.zip", archive).refus);
    }

    @Test
    void desNomsTresLongsNeDemandentPasPlusDeTempsQueDAutres() throws IOException {
        Map<String, byte[]> entrees = new TreeMap<>();
        for (int k = 0; k < 4_000; k++) {
            entrees.put("aé/".repeat(240) + k, new byte[0]);
        }
        entrees.put("lancer/Vecteur.java", octets(CLASSE));
        assertEquals(1, deposer("tp.zip", zip(Map.of("dedans.zip", zip(entrees)))).sources.size());
        entrees.clear();
        for (int k = 0; k < 25_000; k++) {
            entrees.put("tp/.git/objects/" + k, new byte[0]);
        }
        for (int k = 0; k < 60; k++) {
            entrees.put("x".repeat(60_000) + k, new byte[0]);
        }
        entrees.put("lancer/Vecteur.java", octets(CLASSE));
        Rendu rendu = deposer("tp.zip", zip(entrees));
        assertEquals(List.of(), rendu.refus, "ce que des outils ajoutent ne compte pas");
        assertEquals(1, rendu.sources.size());
    }

    @Test
    void ceQuiEstRenduSansSourceEstNomme() throws IOException {
        assertEquals(List.of("aucun fichier .java dans ce rendu ; il contient : Отчёт.txt, проект.jar"),
                deposer("tp.zip", zip(Map.of("a/Отчёт.txt", new byte[9], "проект.jar", new byte[9]))).refus);
        assertEquals(List.of("aucun fichier .java dans ce rendu : des sources Kotlin, et non Java (Vecteur.kt)"),
                deposer("tp.zip", zip(Map.of("a/Vecteur.kt", new byte[9], "a/x.png", new byte[9]))).refus);
        assertEquals(List.of("aucun fichier .java dans ce rendu : des classes compilées, sans leurs sources (A.class)"),
                deposer("tp.zip", zip(Map.of("a/bin/A.class", new byte[9]))).refus);
        assertEquals(List.of("aucun fichier .java dans ce rendu ; il est vide"), deposer("tp.zip", zip(Map.of("a/", new byte[0]))).refus);
    }

    @Test
    void deDeuxFichiersDeMemeCheminUnSeulEstLuEtCEstDit() throws IOException {
        ecrire(rendu.resolve("проект/Vecteur.java"), CLASSE);
        ecrire(rendu.resolve("проект/Point.java"), "la même");
        Rendu lu = deposer("проект.zip", zip(Map.of("Vecteur.java", octets("autre"), "Point.java",
                octets("la même"))));
        assertEquals(CLASSE, new String(lu.sources.get("проект/Vecteur.java"), StandardCharsets.UTF_8));
        assertEquals(List.of("проект/Vecteur.java : laissé de côté, un autre fichier a ce chemin, dans ce dossier ou dans une archive"),
                lu.refus);
    }

    @Test
    void desFichiersVidesNOntPasDeNoteEtSontNommes() throws IOException {
        byte[] lfs = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12\n".getBytes(StandardCharsets.UTF_8);
        Rendu vide = deposer("tp.zip", zip(Map.of("a/Vecteur.java", new byte[0], "a/Point.java", new byte[300], "a/Rayon.java",
                octets(" \n"), "a/Sphere.java", lfs, "src/test/java/lancer/Tests.java", new byte[] {'x'})));
        assertEquals(List.of("un renvoi de Git LFS, sans le texte : Sphere ; des fichiers vides : Point, Rayon, Vecteur"), vide.refus);
        assertEquals(Map.of(), vide.sources);
        ecrire(rendus.resolve("Étudiant 2_12_assignsubmission_file/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Étudiant 2_12_assignsubmission_file/lancer/Point.java"), "");
        Rendu partie = lire(rendus).get("12");
        assertEquals(List.of("des fichiers vides : Point"), partie.refus);
        assertTrue(projet(partie).aRegarder.stream().noneMatch(r -> r.matches(".*Point.* absentes?.*")),
                projet(partie).aRegarder.toString());
    }

    @Test
    void uneArchiveQuiNEstPasCeQueDitSonNomEstNommeeAvecLeRemede() throws IOException {
        for (String[] une : new String[][] {{"Rar!\u001A", "RAR"}, {"7z\u00BC\u00AF", "7z"}}) {
            Rendu rendu = deposer("tp.zip", une[0].getBytes(StandardCharsets.ISO_8859_1));
            assertTrue(rendu.refus.get(0).startsWith("tp.zip : c'est une archive " + une[1] + ", malgré son nom ; à déplier à la main"),
                    rendu.refus.toString());
        }
        Files.delete(rendu.resolve("tp.zip"));
        assertEquals(List.of("aucun fichier .java dans ce rendu ; tp.jar, qui en a 2, est à renommer en .zip"),
                deposer("tp.jar", zip(Map.of("A.java", new byte[9], "B.java", new byte[9]))).refus);
    }

    @Test
    void lesSourcesDUneBibliothequeSontLaisseesEtNommees() throws IOException {
        Map<String, byte[]> bibliotheque = new TreeMap<>();
        for (int k = 0; k < 2500; k++) {
            bibliotheque.put("org/C" + k + ".java", octets("package org; class C" + k + " { }"));
        }
        ecrire(rendu.resolve("tp/lancer/Vecteur.java"), CLASSE);
        Rendu rendu = deposer("src.zip", zip(bibliotheque));
        Projet lu = projet(rendu);
        assertEquals(List.of("src/org : laissé de côté, 2201 fichiers au-delà de 300, ou de 6 Mo de sources : une bibliothèque ?"),
                rendu.refus);
        assertTrue(lu.base.containsKey("lancer/Vecteur"));
    }

    @Test
    void unFichierSeulEstUneLigneSansNote() throws IOException {
        ecrire(rendus.resolve("dupont/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Vecteur.java"), CLASSE);
        Rendu seul = lire(rendus).get("Vecteur.java");
        assertEquals(Map.of(), seul.sources);
        assertTrue(seul.refus.get(0).startsWith("un fichier seul n'est le rendu d'aucun étudiant ; pour un seul rendu : make corriger UN="),
                seul.refus.toString());
    }

    @Test
    void rienEstRefuseEnUnePhrase() {
        assertEquals(2, Assertions.assertThrows(Panne.class, () -> classe(dossier.resolve("absent"))).code);
        assertEquals(2, Assertions.assertThrows(Panne.class, () -> classe(rendus)).code);
    }
}
