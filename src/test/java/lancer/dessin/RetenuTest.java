package lancer.dessin;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import lancer.essai.Essai;
import lancer.essai.Modification;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Une classe qui ne rend jamais la main ne retient pas le programme : dix secondes, et il dit où. */
@Timeout(120)
class RetenuTest {

    private static final String SCENE = "scenes/scene1.ini";
    private static final String DUREE = " : ce calcul dure depuis dix secondes (lancer.";

    /** Sans fin, et sourd à l'arrêt ; sans prendre de processeur aux autres essais. */
    private static final String SANS_FIN = "try { Thread.sleep(600_000); } catch (InterruptedException e) { /* sourd */ }";

    @TempDir
    Path dossier;

    /** La classe, le texte qu'elle change, ce qui le précède, une option, et ce que le programme en dit. */
    private static final String[][] CAS = {
        {"Sphere", "double k = 1 / rayon;", "rayon > 0", "--fils=2", "pixel \\d+, \\d+ de"},
        {"Sphere", "double k = 1 / rayon;", "rayon > 0", "--pixel=200,150", "pixel 200, 150 de"},
        {"Camera", "Point ecran", "xe > 0", "--simple", "pixel \\d+, \\d+ de"},
        {"Sphere", "Point P = incident.getP();", "rayon > 0", "--fils=1", "pixel \\d+, \\d+ de"},
        {"Sphere", "this.centre = centre;", "rayon > 0", "--fils=1", "lecture de"},
        {"Objet3D", "Vecteur V = incident.getV();", "profondeur > 0", "--auto=erreur=2", "pixel \\d+, \\d+ de"}};

    /** Les cas se jugent ensemble : chacun attend dix secondes. */
    @Test
    void leProgrammeNommeLaLigneQuiLeRetientEtNeSArreteQueSiRienNAvance() throws Exception {
        Path attendue = dossier.resolve("attendue.png");
        assertEquals(0, Essai.executer("--taille=40x30", "--image", attendue.toString(), SCENE).code);
        List<Callable<Void>> essais = new ArrayList<>();
        essais.add(() -> essayerUnPixelLentDontLesRayonsAvancent(attendue));
        for (String[] cas : CAS) {
            Path sien = Files.createDirectories(dossier.resolve("cas" + essais.size()));
            essais.add(() -> essayer(sien, cas));
        }
        ExecutorService fils = Executors.newFixedThreadPool(essais.size());
        try {
            for (Future<Void> essai : fils.invokeAll(essais)) {
                essai.get();
            }
        } finally {
            fils.shutdownNow();
        }
    }

    private static Void essayer(Path dossier, String[] cas) throws IOException {
        Path image = dossier.resolve("i.png");
        try (Essai.Isole programme = Modification.de(dossier, cas[0], cas[1], "while (" + cas[2] + ") { " + SANS_FIN + " } " + cas[1])) {
            Essai essai = cas[3].startsWith("--pixel") ? programme.executer("--taille=400x300", cas[3], SCENE)
                    : programme.executer("--taille=400x300", cas[3], "--image", image.toString(), SCENE);
            assertEquals(1, essai.code, essai.toString());
            assertTrue(essai.erreur.matches("(?s)lancer : " + cas[4] + " " + SCENE + ".*"), essai.erreur);
            assertTrue(essai.erreur.contains(DUREE + cas[0] + ".") && essai.erreur.contains(", " + cas[0] + ".java:"), essai.erreur);
            assertEquals(1, essai.erreur.trim().split("\n").length, essai.erreur);
            assertFalse(Files.exists(image));
        }
        return null;
    }

    /** Il est nommé, et dessiné comme un autre. */
    private Void essayerUnPixelLentDontLesRayonsAvancent(Path attendue) throws IOException {
        Path image = dossier.resolve("i.png");
        try (Essai.Isole programme = Modification.de(dossier, "Lancer", "Rayon initial =", "for (int k = 0; xe == 20.5 && ye == 15.5 "
                + "&& k < 130; k++) { scene.getCompteurs().ombre++; java.util.concurrent.locks.LockSupport.parkNanos(100_000_000); }"
                + "Rayon initial =")) {
            Essai essai = programme.executer("--taille=40x30", "--image", image.toString(), SCENE);
            assertEquals(0, essai.code, essai.toString());
            assertTrue(essai.erreur.startsWith("lancer : pixel 20, 15 de " + SCENE + DUREE + "Lancer.getCouleurPixel, Lancer.java:"),
                    essai.erreur);
            assertEquals(1, essai.erreur.trim().split("\n").length, essai.erreur);
        }
        assertArrayEquals(Files.readAllBytes(attendue), Files.readAllBytes(image));
        return null;
    }
}
