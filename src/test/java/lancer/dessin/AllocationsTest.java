package lancer.dessin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Paths;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.rapide.Preparation;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * La mémoire que demande un pixel tant que rien n'est compilé : chaque vecteur, chaque point, chaque couleur y est vraiment fait. C'est
 * ce que paie la première image. Un compte, le même à chaque fois.
 */
class AllocationsTest {

    private static final int LARGEUR = 80;
    private static final int HAUTEUR = 60;

    /** Ce qui est atteint, en octets par pixel, plus un dixième. */
    @ParameterizedTest(name = "{0} : au plus {1} octets par pixel")
    @CsvSource({"scene1, 1485", "bowling, 1396", "tournesol, 1756"})
    void unPixelNeDemandePasPlusDeMemoireQuAujourdhui(String scene, double auPlus) throws IOException, InterruptedException {
        Process machine = new ProcessBuilder(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-Xint", "-cp",
                System.getProperty("java.class.path"), AllocationsTest.class.getName(), "scenes/" + scene + ".ini").start();
        try (BufferedReader sortie = new BufferedReader(new InputStreamReader(machine.getInputStream(), StandardCharsets.UTF_8))) {
            double octets = Double.parseDouble(sortie.readLine());
            assertEquals(0, machine.waitFor());
            assertTrue(octets <= auPlus, octets + " octets par pixel");
            assertTrue(octets >= auPlus / 1.25, octets + " octets par pixel : la borne est à baisser");
        } finally {
            machine.destroyForcibly();
        }
    }

    /** Dessine cette scène dans ce fil, et dit ce que chaque pixel lui a demandé. */
    public static void main(String[] args) {
        Scene scene = new Scene(args[0]);
        Camera camera = new Camera(LARGEUR, HAUTEUR);
        scene.getModele().setRecherche(Preparation.pour(scene, camera, part -> { }));
        Lancer lancer = new Lancer(scene, camera);
        com.sun.management.ThreadMXBean fils = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long avant = 0;
        // les classes se chargent au premier passage
        for (int fois = 0; fois < 2; fois++) {
            avant = fils.getThreadAllocatedBytes(Thread.currentThread().getId());
            for (int k = 0; k < LARGEUR * HAUTEUR; k++) {
                lancer.getCouleurPixel(k % LARGEUR + 0.5, k / LARGEUR + 0.5, Constantes.MAX_REFLETS);
            }
        }
        System.out.println((fils.getThreadAllocatedBytes(Thread.currentThread().getId()) - avant) / (double) (LARGEUR * HAUTEUR));
    }
}
