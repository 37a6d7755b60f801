package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Paths;
import lancer.Scene;
import lancer.dessin.Dessin;
import lancer.mesures.scenes.SceneAuHasard;
import lancer.mesures.scenes.Scenes;
import lancer.scene.LecteurScene;
import org.junit.jupiter.api.Test;

/** L'erreur d'une image, contre deux images au hasard. */
class GabaritTest {

    private static final int LARGEUR = 160;
    private static final int HAUTEUR = 120;

    /** Celle dont la vérité coûte plus : mille réflexions. */
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
        Gabarit seme = new Gabarit(scene, LARGEUR, HAUTEUR, 3, Gabarit.COTE, (i, j) -> true);
        assertEquals(54 * 40, seme.carres(image).length, "un par carré");
        assertEquals(1, erreur(seme, image) / erreur(new Gabarit(scene, LARGEUR, HAUTEUR, 1, Gabarit.COTE, (i, j) -> true), image), 0.15);
    }

    @Test
    void laVeriteNAPasDeLimiteDeReflexions() {
        Scene miroirs = Scenes.lire(LecteurScene.trouver(Paths.get("scenes", "miroirs.ini").toString()));
        Gabarit gabarit = new Gabarit(miroirs, L, H, 2, Gabarit.COTE, (i, j) -> true);
        double cinq = erreur(gabarit, image(miroirs, L, H, 5));
        double cent = erreur(gabarit, image(miroirs, L, H, 100));
        assertTrue(cent < 0.7 * cinq, cent + " contre " + cinq);
    }

}
