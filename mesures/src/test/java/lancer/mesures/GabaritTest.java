package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Paths;
import java.util.Arrays;
import java.util.stream.IntStream;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.atelier.SceneAuHasard;
import lancer.atelier.Scenes;
import lancer.lecture.FichierScene;
import lancer.temoins.LancerSurveille;
import org.junit.jupiter.api.Test;

/** L'erreur d'une image, contre deux images au hasard. */
class GabaritTest {

    private static final int LARGEUR = 160;
    private static final int HAUTEUR = 120;

    /** Celles dont la vérité se calcule aussi par 1024 rayons par pixel. */
    private static final int L = 56;
    private static final int H = 42;

    private static ImageLineaire image(Scene scene, int reflets) {
        return ImageLineaire.de(LancerSurveille.preparer(scene, LARGEUR, HAUTEUR, false), reflets, 2);
    }

    @Test
    void lesPixelsSemesDonnentLErreurDeTouteLImage() {
        Scene scene = SceneAuHasard.de(2);
        Gabarit entier = new Gabarit(scene, LARGEUR, HAUTEUR, 1);
        Gabarit seme = new Gabarit(scene, LARGEUR, HAUTEUR, 3);
        double[] carres = seme.carres(image(scene, 5));
        assertEquals(54 * 40, carres.length, "un par carré");
        double attendue = Intervalle.deLaRacine(entier.carres(image(scene, 5))).valeur;
        assertEquals(1, Intervalle.deLaRacine(carres).valeur / attendue, 0.15);
    }

    @Test
    void laVeriteNAPasDeLimiteDeReflexions() {
        Scene miroirs = Scenes.lire(FichierScene.trouver(Paths.get("scenes", "miroirs.ini").toString()));
        Gabarit gabarit = new Gabarit(miroirs, LARGEUR, HAUTEUR, 4);
        double cinq = Arrays.stream(gabarit.carres(image(miroirs, 5))).average().getAsDouble();
        double cent = Arrays.stream(gabarit.carres(image(miroirs, 100))).average().getAsDouble();
        assertTrue(cent < cinq / 4, cent + " contre " + cinq);
    }

    /** La moyenne de 1024 rayons réguliers par pixel, sans limite. */
    private static ImageLineaire verite(Scene scene) {
        Scene fine = scene.avec(Antialias.coins(32, 0), 0);
        return ImageLineaire.de(LancerSurveille.preparer(fine, L, H, false), Gabarit.PROFONDEUR, 2);
    }

    /** En niveaux, de couleurs limitées à [0, 1]. */
    private static double erreur(ImageLineaire image, ImageLineaire verite) {
        double[] a = image.getComposantes();
        double[] b = verite.getComposantes();
        return 255 * Math.sqrt(IntStream.range(0, a.length).mapToDouble(k -> Math.pow(Math.min(1, a[k]) - Math.min(1, b[k]), 2))
                .average().getAsDouble());
    }

    @Test
    void leGabaritMesureLErreurContreLaVerite() {
        for (long graine : new long[] {1, 2}) {
            Scene scene = SceneAuHasard.de(graine);
            ImageLineaire verite = verite(scene);
            Gabarit gabarit = new Gabarit(scene, L, H, 1);
            for (int reflets : new int[] {0, 5}) {
                ImageLineaire image = ImageLineaire.de(LancerSurveille.preparer(scene, L, H, false), reflets, 2);
                double attendue = erreur(image, verite);
                assertEquals(1, Intervalle.deLaRacine(gabarit.carres(image)).valeur / attendue, 0.05,
                        "graine " + graine + ", " + attendue + " niveaux");
            }
        }
    }

    @Test
    void uneImageJusteNAPasDErreur() {
        Scene scene = SceneAuHasard.de(1);
        ImageLineaire verite = verite(scene);
        // ce qui reste est le hasard des deux images, qui ne fait que s'annuler à peu près
        assertTrue(Intervalle.deLaRacine(new Gabarit(scene, L, H, 1).carres(verite)).valeur < 0.5);
    }
}
