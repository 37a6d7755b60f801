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
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.correction.ClasseEssai;
import lancer.correction.Panne;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

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
        ecrireLien(lien, "Vecteur.java", secret.toString());
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
                zip.putNextEntry(new ZipEntry("Étudiant_" + k % 30 + "_assignsubmission_file/.git/" + k));
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

    @Test
    void rienEstRefuseEnUnePhrase() {
        assertEquals(2, Assertions.assertThrows(Panne.class, () -> classe(dossier.resolve("absent"))).code);
        assertEquals(2, Assertions.assertThrows(Panne.class, () -> classe(rendus)).code);
    }
}
