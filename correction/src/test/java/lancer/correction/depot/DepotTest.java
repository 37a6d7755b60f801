package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
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
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/src/main/java/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Étudiant 1_12_assignsubmission_file_/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Participant_13_assignsubmission_file_Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Étudiant 3_14_assignsubmission_onlinetext/onlinetext.html"), "bonjour");
        Map<String, Rendu> lus = lire(rendus);
        assertEquals(new TreeSet<>(List.of("11", "12", "13", "14")), new TreeSet<>(lus.keySet()));
        verifier(lus.get("11"), "Étudiant 1");
        verifier(lus.get("12"), "Étudiant 1");
        verifier(lus.get("13"), "Participant");
        assertEquals(List.of("aucun fichier dans ce rendu"), lus.get("14").refus);
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
        ClasseEssai.ecrireLien(lien, "Vecteur.java", secret.toString());
        Map<String, Rendu> lus = lire(rendus);
        assertEquals(7, lus.size());
        refuse(lus.get("11"), "tp.rar : à déplier à la main");
        refuse(lus.get("12"), "tp.7z : à déplier à la main");
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

    @Test
    void ceQuiResteADeplierEstARegarderMemeACoteDeSources() throws IOException {
        for (String nom : List.of("tp.7z", "TP.RAR", "tp.tar.gz", "tp.tgz", "tp.7z.001", "tp.zip.002", "tp.tar.zst")) {
            ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/" + nom), "x");
        }
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Vecteur.java"), CLASSE);
        Rendu rendu = lire(rendus).get("11");
        assertEquals(7, rendu.refus.stream().filter(r -> r.contains(" : à déplier à la main")).count(), rendu.refus.toString());
        assertEquals("[lancer/Vecteur]", projet(rendu).base.keySet().toString());
        assertEquals(rendu.refus, projet(rendu).remarques);
    }

    @Test
    void niLaLongueurNiLesSignesDUnNomNeTouchentAuxFichiersNiAuxAutresRendus() throws IOException {
        String accent = "%C3%A9";
        for (String nom : List.of("x".repeat(252), "x".repeat(251) + "y", "a%0Ab", "%1B%5B2K", "m" + accent, "m%E9", "m%E8", "%E2%80%8F")) {
            Path dossier = Path.of(java.net.URI.create(rendus.toUri() + nom));
            ecrire(dossier.resolve("lancer").resolve("Vecteur.java"), CLASSE);
        }
        // une barre à l'envers n'est pas celle d'un dossier : celui-là n'entre pas chez un autre
        ecrire(rendus.resolve("martin/lancer/Vecteur.java"), CLASSE);
        ClasseEssai.archiver(rendus.resolve("martin"), rendus.resolve("martin\\dupont.zip"), "");
        List<Rendu> lus = classe(rendus);
        assertEquals(10, lus.size());
        TreeSet<String> ids = new TreeSet<>();
        TreeSet<String> fichiers = new TreeSet<>();
        for (int rang = 0; rang < lus.size(); rang++) {
            Rendu rendu = lus.get(rang);
            assertEquals(1, rendu.sources.size(), rendu.id);
            assertTrue((rendu.nom + rendu.id).matches("[\\P{C}&&[^\\u200F]]{2,150}"), rendu.nom);
            assertTrue(rendu.fichier(rang).matches("[A-Za-z0-9-]{4,80}"), rendu.fichier(rang));
            ids.add(rendu.id);
            fichiers.add(rendu.fichier(rang));
        }
        assertEquals(List.of(10, 10), List.of(ids.size(), fichiers.size()));
    }

    @Test
    void beaucoupDeFichiersEnToutNeSontPasTropPourUneClasse() throws IOException {
        Path moodle = dossier.resolve("moodle.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(moodle))) {
            for (int k = 0; k < 20_001; k++) {
                zip.putNextEntry(new ZipEntry("Étudiant_" + (7 + k % 2) + "_assignsubmission_file/.git/" + k));
            }
            zip.putNextEntry(new ZipEntry("Étudiant_7_assignsubmission_file/lancer/Vecteur.java"));
            zip.write(CLASSE.getBytes(StandardCharsets.UTF_8));
        }
        Map<String, Rendu> lus = lire(moodle);
        verifier(lus.get("7"), "Étudiant");
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
            rendu.sources.put(nom + ".java", octets);
            projet(rendu).base.keySet().forEach(cle -> assertTrue(cle.matches("(\\w+/)*[\\p{L}_$][\\p{L}\\p{N}_$]*"), cle));
        }
    }

    private static byte[] zip(Map<String, byte[]> entrees) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(octets)) {
            for (Map.Entry<String, byte[]> entree : entrees.entrySet()) {
                zip.putNextEntry(new ZipEntry(entree.getKey()));
                zip.write(entree.getValue());
            }
        }
        return octets.toByteArray();
    }

    private Rendu deposer(String nom, byte[] archive) throws IOException {
        Files.write(Files.createDirectories(rendus.resolve("Étudiant 1_11_assignsubmission_file")).resolve(nom), archive);
        return lire(rendus).get("11");
    }

    /** Ce que 7-Zip sait écrire et que la bibliothèque, seule, ne sait pas lire. */
    @ParameterizedTest
    @CsvSource({"95, XZ", "93, ZSTD", "14, LZMA", "98, PPMD", "177, 177"})
    void uneCompressionQuiNEstPasLueEstNommeeUneFois(int methode, String nom) throws IOException {
        byte[] archive = zip(Map.of("лучи/Vecteur.java", CLASSE.getBytes(StandardCharsets.UTF_8), "лучи/Point.java", new byte[9]));
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
    void desFichesParMillionsNeSontPasRetenuesAQuelqueProfondeurQueCeSoit() throws IOException {
        byte[] une = zip(Map.of("é", new byte[0]));
        int fiche = 0;
        while (ByteBuffer.wrap(une).getInt(fiche) != 0x504b0102) {
            fiche++;
        }
        int fin = une.length - 22;
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        octets.write(une, 0, fiche);
        for (int k = 0; k < 900_000; k++) {
            octets.write(une, fiche, fin - fiche);
        }
        octets.write(ByteBuffer.wrap(une, fin, 22).order(ByteOrder.LITTLE_ENDIAN).putInt(fin + 12, octets.size() - fiche).array(), fin, 22);
        byte[] archive = octets.toByteArray();
        for (int niveau = 0; niveau < 3; niveau++) {
            Rendu rendu = deposer("tp.zip", archive);
            assertEquals(List.of("plus de 20000 fichiers"), rendu.refus);
            archive = zip(Map.of("n" + niveau + ".zip", archive));
        }
    }

    @Test
    void desNomsTresLongsNeDemandentPasPlusDeTempsQueDAutres() throws IOException {
        Map<String, byte[]> entrees = new TreeMap<>();
        for (int k = 0; k < 19_000; k++) {
            entrees.put("aé/".repeat(240) + k, new byte[0]);
        }
        entrees.put("lancer/Vecteur.java", CLASSE.getBytes(StandardCharsets.UTF_8));
        assertEquals(1, deposer("tp.zip", zip(Map.of("dedans.zip", zip(entrees)))).sources.size());
        entrees.clear();
        for (int k = 0; k < 300; k++) {
            entrees.put("x".repeat(60_000) + k, new byte[0]);
        }
        entrees.put("lancer/Vecteur.java", CLASSE.getBytes(StandardCharsets.UTF_8));
        Rendu rendu = deposer("tp.zip", zip(entrees));
        assertEquals(List.of("des noms de plus de 1000 caractères : laissés de côté"), rendu.refus);
        for (int k = 0; k < 25_000; k++) {
            entrees.put("tp/.git/objects/" + k, new byte[0]);
        }
        assertEquals(rendu.refus, deposer("tp.zip", zip(entrees)).refus, "ce que des outils ajoutent ne compte pas");
        assertEquals(1, rendu.sources.size());
    }

    @Test
    void ceQuiEstRenduSansSourceEstNomme() throws IOException {
        assertEquals(List.of("aucun fichier .java dans ce rendu ; il contient : Отчёт.txt, проект.jar"),
                deposer("tp.zip", zip(Map.of("a/Отчёт.txt", new byte[9], "проект.jar", new byte[9]))).refus);
        assertEquals(List.of("aucun fichier .java dans ce rendu ; il contient : bin"),
                deposer("tp.zip", zip(Map.of("a/bin/A.java", new byte[9]))).refus);
        assertEquals(List.of("aucun fichier .java dans ce rendu ; il est vide"), deposer("tp.zip", zip(Map.of("a/", new byte[0]))).refus);
    }

    @Test
    void deDeuxFichiersDeMemeCheminUnSeulEstLuEtCEstDit() throws IOException {
        Path rendu = rendus.resolve("Étudiant 1_11_assignsubmission_file");
        ecrire(rendu.resolve("проект/Vecteur.java"), CLASSE);
        ecrire(rendu.resolve("проект/Point.java"), "la même");
        Rendu lu = deposer("проект.zip", zip(Map.of("Vecteur.java", new byte[9], "Point.java",
                "la même".getBytes(StandardCharsets.UTF_8))));
        assertEquals(CLASSE, new String(lu.sources.get("проект/Vecteur.java"), StandardCharsets.UTF_8));
        assertEquals(List.of("проект/Vecteur.java : laissé de côté, un autre fichier a ce chemin, dans ce dossier ou dans une archive"),
                projet(lu).aRegarder);
    }

    @Test
    void uneLectureArreteeNeCouteQueSonRendu() throws IOException {
        for (String nom : List.of("a", "b", "c")) {
            ecrire(rendus.resolve(nom).resolve("lancer/Vecteur.java"), CLASSE);
        }
        for (Error cause : List.of(new NoClassDefFoundError("org/x/Y"), new OutOfMemoryError("x"), new StackOverflowError())) {
            Map<String, Rendu> lus = Depot.lire(rendus, noms -> {
                if (noms.containsKey("b")) {
                    throw cause;
                }
                return repondre(rendus, noms);
            }).stream().collect(Collectors.toMap(r -> r.id, r -> r));
            assertEquals(List.of("arrêté : " + cause + " (en lisant ses fichiers)"), lus.get("b").refus);
            assertEquals(List.of(1, 0, 1), lus.values().stream().map(r -> r.sources.size()).collect(Collectors.toList()));
        }
    }

    @Test
    void rienEstRefuseEnUnePhrase() {
        assertEquals(2, Assertions.assertThrows(Panne.class, () -> classe(dossier.resolve("absent"))).code);
        assertEquals(2, Assertions.assertThrows(Panne.class, () -> classe(rendus)).code);
    }
}
