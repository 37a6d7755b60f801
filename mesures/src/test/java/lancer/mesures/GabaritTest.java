package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Paths;
import java.util.Arrays;
import lancer.Scene;
import lancer.atelier.Scenes;
import lancer.lecture.FichierScene;
import lancer.temoins.LancerSurveille;
import org.junit.jupiter.api.Test;

/** L'erreur d'une image, contre deux images au hasard. */
class GabaritTest {

    private static final int LARGEUR = 160;
    private static final int HAUTEUR = 120;

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
}
