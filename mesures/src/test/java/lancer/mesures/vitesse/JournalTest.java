package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import lancer.mesures.FichierCsv;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Le journal des mesures. */
class JournalTest {

    @TempDir
    Path dossier;

    private Journal journal() {
        return new Journal(dossier.resolve("atelier").resolve(Ouvrier.CSV));
    }

    /** Une ligne dont chaque champ est le nom de sa colonne, sauf le paramètre. */
    private static String ligne(String parametres) {
        Object[] champs = Releve.COLONNES.toArray();
        champs[Releve.COLONNES.indexOf("parametres")] = parametres;
        return FichierCsv.ligne(champs);
    }

    private List<String> parametres() throws IOException {
        return journal().lire().stream().map(r -> r.parametres).collect(Collectors.toList());
    }

    @Test
    void ilEstVideTantQueRienNEstMesure() throws IOException {
        assertTrue(journal().lire().isEmpty());
        assertTrue(journal().clesFaites().isEmpty());
    }

    @Test
    void ilRendCeQuiYAEteNoteVirgulesEtGuillemetsCompris() throws IOException {
        journal().ajouter(ligne("n=3 seuil=0.05"));
        journal().ajouter(ligne("a, « b » et \"c\""));
        assertEquals(Arrays.asList("n=3 seuil=0.05", "a, « b » et \"c\""), parametres());
        assertEquals("machine", journal().lire().get(0).texte("machine"));
        assertTrue(journal().clesFaites().contains("scene/famille/methode/n=3 seuil=0.05"));
    }

    @Test
    void ilOublieUneLigneCoupeeEtRienDAutre() throws IOException {
        journal().ajouter(ligne("un"));
        journal().ajouter(ligne("deux"));
        Files.write(journal().getFichier(), "AMD,2,jvm,2026".getBytes(StandardCharsets.UTF_8), StandardOpenOption.APPEND);
        assertEquals(Arrays.asList("un", "deux"), parametres());
        journal().ajouter(ligne("trois"));
        assertEquals(Arrays.asList("un", "deux", "trois"), parametres());
        assertEquals(4, Files.readAllLines(journal().getFichier()).size());
    }

    @Test
    void ilOublieUnEnTeteCoupe() throws IOException {
        Files.createDirectories(journal().getFichier().getParent());
        Files.write(journal().getFichier(), "machine,coe".getBytes(StandardCharsets.UTF_8));
        assertTrue(journal().lire().isEmpty());
        journal().ajouter(ligne("un"));
        assertEquals(Collections.singletonList("un"), parametres());
    }

    @Test
    void uneLigneQuiNAPasLeCompteDeChampsEstRefusee() throws IOException {
        journal().ajouter(ligne("un"));
        journal().ajouter("trop,peu");
        assertThrows(IOException.class, () -> journal().lire());
    }

    @Test
    void onReprendOuLOnEnEtaitEtCeQuiEstFaitNeLEstPasDeuxFois() throws IOException {
        Travail travail = Travail.tous(true).stream().filter(t -> t.scene.equals("foule-10")).findFirst().get();
        ouvrier(travail).faire();
        List<String> completes = Files.readAllLines(journal().getFichier());
        assertEquals(1 + travail.methodes().size(), completes.size());
        ouvrier(travail).faire();
        assertEquals(completes, Files.readAllLines(journal().getFichier()));
        Files.write(journal().getFichier(), completes.subList(0, 2));
        ouvrier(travail).faire();
        assertEquals(completes.get(1), Files.readAllLines(journal().getFichier()).get(1), "la première n'est pas refaite");
        assertEquals(completes.size(), Files.readAllLines(journal().getFichier()).size());
    }

    private Ouvrier ouvrier(Travail travail) throws IOException {
        return new Ouvrier(travail, true, journal().getFichier().getParent(),
                new PrintStream(new ByteArrayOutputStream(), true, "UTF-8"));
    }

    @Test
    void quandLaMachineVirtuelleEstTueeToutCeQuiEtaitFiniEstGarde() throws IOException, InterruptedException {
        int rang = 0;
        while (Travail.tous(true).get(rang).famille != Famille.REFLETS) {
            rang++;
        }
        Process processus = new ProcessBuilder(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), Ouvrier.class.getName(), String.valueOf(rang), "true",
                journal().getFichier().getParent().toString()).redirectErrorStream(true).start();
        try {
            // la vérité et deux mesures : il en reste
            while (processus.isAlive() && journal().lire().size() < 3) {
                TimeUnit.MILLISECONDS.sleep(5);
            }
        } finally {
            processus.destroyForcibly().waitFor();
        }
        int finies = journal().lire().size();
        assertTrue(finies >= 3, finies + " mesures");
        journal().ajouter(ligne("la suite"));
        assertEquals(finies + 1, journal().lire().size());
    }
}
