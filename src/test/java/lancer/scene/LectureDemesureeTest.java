package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Des fichiers faits pour épuiser le temps ou la mémoire. La mémoire est comptée ; le temps ne l'est que par un délai qu'une
 * lecture de coût quadratique dépasserait de très loin.
 */
@Timeout(value = 5, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class LectureDemesureeTest {

    private static final String DEBUT = "[Sphere 1]\ncentre=0 0 6\n";

    @TempDir
    Path dossier;

    private Path ecrire(String debut, String motif, int fois, String fin) throws IOException {
        Path fichier = dossier.resolve("demesuree.ini");
        try (OutputStream s = Files.newOutputStream(fichier)) {
            s.write(debut.getBytes(StandardCharsets.UTF_8));
            s.write(Abimeur.repete(motif.getBytes(StandardCharsets.UTF_8), fois));
            s.write(fin.getBytes(StandardCharsets.UTF_8));
        }
        return fichier;
    }

    /** Lit cette scène, avec la mémoire que vaut sa taille. */
    private static Scene lire(Path fichier) throws IOException {
        long avant = Memoire.demandee();
        try {
            return new Scene(fichier.toString());
        } finally {
            Memoire.verifier(avant, Files.size(fichier), "lecture");
        }
    }

    /** Le message attendu, le fichier ôté. */
    private static void refuse(String attendu, Path fichier) {
        String message = assertThrows(SceneFautive.class, () -> lire(fichier)).getMessage();
        assertEquals(attendu, message.substring(fichier.toString().length()).split(" ;")[0].replaceAll("(.)\\1{20,}", "$1*"));
    }

    @ParameterizedTest(name = "rayon={0}({1} un million de fois){2}")
    @CsvSource({"'', 7, '', nombre trop grand : « 7*… »", "0., 0, 1, hors limites : « 0.0*… »", "1e, 9, '', nombre trop grand : « 1e9*… »",
        "1e-, 9, '', hors limites : « 1e-9*… »",
        "'', ' 1', '', 1000000 nombres au lieu de 1 : « 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1… »",
        "'', -, '', n'est pas un nombre : « -*… »",
        "x, ${a}, '', n'est pas un nombre : « x${a}${a}${a}${a}${a}${a}${a}${a}${a}${a}${a}${a}${a}${a}${… »"})
    void uneValeurDUnMillionDeSignesEstRefusee(String debut, String motif, String fin, String faute) throws IOException {
        refuse(", ligne 3, [Sphere 1], rayon : " + faute, ecrire(DEBUT + "rayon=" + debut, motif, 1_000_000, fin));
    }

    @Test
    void unNombreJusteDUnMillionDeChiffresEstLu() throws IOException {
        Scene scene = lire(ecrire(DEBUT + "rayon=1.5", "0", 1_000_000, "1"));
        assertEquals(1.5, ((Sphere) scene.getObjets().get(0)).getRayon());
        scene = lire(ecrire(DEBUT + "rayon=", "0", 1_000_000, "2.5e0"));
        assertEquals(2.5, ((Sphere) scene.getObjets().get(0)).getRayon());
    }

    @Test
    void unNomDeSectionDUnMillionDeNiveauxNEstQuUnNom() throws IOException {
        assertEquals(1, lire(ecrire("[Sphere a", "/a", 1_000_000, "]\ncentre=0 0 6\nrayon=1")).getObjets().size());
        refuse(", ligne 1 : texte avant toute section : « [*… »", ecrire("", "[", 1_000_000, ""));
        refuse(", ligne 1 : texte avant toute section : « [ *… »", ecrire("[", " ", 1_000_000, "]"));
    }

    @Test
    void desMillionsDeLignesVidesOuDeCommentairesNeSontPasGardes() throws IOException {
        assertEquals(1, lire(ecrire(DEBUT, "\n", 3_000_000, "rayon=1")).getObjets().size());
        assertEquals(1, lire(ecrire(DEBUT, ";\r", 2_000_000, "rayon=1")).getObjets().size());
        refuse(", ligne 3000003, [Sphere 1], rayon : 0 nombre au lieu de 1 : «  »", ecrire(DEBUT, "\r", 3_000_000, "rayon="));
    }

    @Test
    void uneLigneDeCaracteresNulsEstRefusee() throws IOException {
        refuse(", ligne 1 : texte avant toute section : « \\u0000\\u0000\\u0000\\u0000\\u0000\\u0000\\u0000\\u0000\\u0000\\u000… »",
                ecrire("", "\0", 1_000_000, ""));
    }

    @Test
    void uneLigneDePlusDeHuitMegaoctetsEstTropLongue() throws IOException {
        assertEquals(1, lire(ecrire(DEBUT + "rayon=1", " ", 8_000_000, "")).getObjets().size());
        refuse(", ligne 3, [Sphere 1] : lecture impossible (ligne de plus de 8 Mo)", ecrire(DEBUT + "rayon=1", " ", 10_000_000, ""));
        refuse(", ligne 3, [Sphere 1] : lecture impossible (ligne de plus de 8 Mo)", ecrire(DEBUT + ";", "x", 10_000_000, "\nrayon=1"));
    }

    @Test
    void laPartLueSeDitDuDebutALaFin() throws IOException {
        Path fichier = ecrire(DEBUT + "rayon=1\n", ";\n", 200_000, "");
        List<Double> parts = new ArrayList<>();
        LecteurScene.lire(fichier.toString(), parts::add);
        assertTrue(parts.size() >= 6, parts.toString());
        assertTrue(parts.get(0) > 0 && parts.get(0) <= 65536.0 / Files.size(fichier), parts.toString());
        assertEquals(1, parts.get(parts.size() - 1));
        assertEquals(parts.stream().sorted().collect(Collectors.toList()), parts);
    }

    @Test
    void uneLectureInterrompueSArrete() throws IOException {
        Path fichier = ecrire(DEBUT + "rayon=1\n", ";\n", 1_000_000, "");
        Thread.currentThread().interrupt();
        try {
            assertThrows(CancellationException.class, () -> lire(fichier));
        } finally {
            assertTrue(Thread.interrupted(), "le fil appelant reste interrompu");
        }
    }

    @Test
    void desClesSansFinSontRefusees() throws IOException {
        String cles = IntStream.rangeClosed(1, 100_000).mapToObj(k -> "k" + k + "=1\n").collect(Collectors.joining());
        refuse(", ligne 66, [Brume], k65 : trop de clés", ecrire("[Brume]\n", "", 0, cles));
    }

    /** Des doubles de [0.5, 1[ dont {@code Double.hashCode} est toujours le même. */
    private static double memeCode(int k) {
        long haut = 0x3FE00000L + k;
        return Double.longBitsToDouble(haut << 32 | haut ^ 0x12345678L);
    }

    @Test
    void desCentresOuDesCouleursDeMemeCodeNeRalentissentPas() throws IOException {
        int combien = 200_000;
        StringBuilder s = new StringBuilder();
        for (int k = 0; k < combien; k++) {
            assertEquals(Double.hashCode(memeCode(0)), Double.hashCode(memeCode(k)));
            double x = memeCode(k);
            s.append("[Sphere ").append(k).append("]\ncentre=").append(x).append(" 0 6\nrayon=1\nKd=").append(x).append(" 0 0\n");
        }
        assertEquals(combien, lire(ecrire(s.toString(), "", 0, "")).getObjets().size());
    }

    @Test
    void desNomsDeMemeCodeNeRalentissentPas() throws IOException {
        StringBuilder s = new StringBuilder();
        for (int k = 0; k < 1 << 16; k++) {
            s.append("[Lampe ");
            for (int bit = 0; bit < 16; bit++) {
                // deux textes de même code, qu'on peut enchaîner
                s.append((k >> bit & 1) == 0 ? "Aa" : "BB");
            }
            s.append("]\nposition=0 1 2\ncouleur=1 1 1\n");
        }
        assertEquals(1 << 16, lire(ecrire(s.toString(), "", 0, "")).getLampes().size());
    }
}
