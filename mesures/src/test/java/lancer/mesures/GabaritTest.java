package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Paths;
import java.util.stream.IntStream;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.dessin.Dessin;
import lancer.mesures.scenes.SceneAuHasard;
import lancer.mesures.scenes.Scenes;
import lancer.scene.FichierScene;
import org.junit.jupiter.api.Test;

/** L'erreur d'une image, contre deux images au hasard. */
class GabaritTest {

    private static final int LARGEUR = 160;
    private static final int HAUTEUR = 120;

    /** Celles dont la vérité coûte plus : 1024 rayons par pixel, ou mille réflexions. */
    private static final int L = 56;
    private static final int H = 42;

    private static ImageLineaire image(Scene scene, int largeur, int hauteur, int reflets) {
        return ImageLineaire.de(Dessin.lancer(scene, largeur, hauteur, false), reflets, 2);
    }

    private static double erreur(Gabarit gabarit, ImageLineaire image) {
        return Intervalle.deLaRacine(gabarit.carres(image)).valeur;
    }

    @Test
    void lesPixelsSemesDonnentLErreurDeTouteLImage() {
        Scene scene = SceneAuHasard.de(2);
        ImageLineaire image = image(scene, LARGEUR, HAUTEUR, 5);
        Gabarit seme = new Gabarit(scene, LARGEUR, HAUTEUR, 3);
        assertEquals(54 * 40, seme.carres(image).length, "un par carré");
        assertEquals(1, erreur(seme, image) / erreur(new Gabarit(scene, LARGEUR, HAUTEUR, 1), image), 0.15);
    }

    @Test
    void laVeriteNAPasDeLimiteDeReflexions() {
        Scene miroirs = Scenes.lire(FichierScene.trouver(Paths.get("scenes", "miroirs.ini").toString()));
        Gabarit gabarit = new Gabarit(miroirs, L, H, 2);
        double cinq = erreur(gabarit, image(miroirs, L, H, 5));
        double cent = erreur(gabarit, image(miroirs, L, H, 100));
        assertTrue(cent < 0.7 * cinq, cent + " contre " + cinq);
    }

    /** En niveaux, de couleurs limitées à [0, 1]. */
    private static double erreur(ImageLineaire image, ImageLineaire verite) {
        double[] a = image.getComposantes();
        double[] b = verite.getComposantes();
        return 255 * Math.sqrt(IntStream.range(0, a.length).mapToDouble(k -> Math.pow(Math.min(1, a[k]) - Math.min(1, b[k]), 2))
                .average().getAsDouble());
    }

    @Test
    void leGabaritMesureLErreurContreLaVeriteEtLaVeriteNEnAPas() {
        for (long graine : new long[] {1, 2}) {
            Scene scene = SceneAuHasard.de(graine);
            ImageLineaire verite = image(scene.avec(scene.getModele().avec(Antialias.coins(32, 0), 0)), L, H, Gabarit.PROFONDEUR);
            Gabarit gabarit = new Gabarit(scene, L, H, 1);
            for (int reflets : new int[] {0, 5}) {
                ImageLineaire image = image(scene, L, H, reflets);
                double attendue = erreur(image, verite);
                assertEquals(1, erreur(gabarit, image) / attendue, 0.05, "graine " + graine + ", " + attendue + " niveaux");
            }
            // ce qui reste est le hasard des deux images, qui ne fait que s'annuler à peu près
            assertTrue(erreur(gabarit, verite) < 0.5);
        }
    }
}
