package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.temoins.LancerSurveille;
import org.junit.jupiter.api.Test;

/** Ce qui juge {@code --auto}. */
class MesureAutoTest {

    private static final int LARGEUR = 56;
    private static final int HAUTEUR = 42;

    /** La moyenne de 1024 rayons réguliers par pixel, sans limite. */
    private static ImageLineaire verite(Scene scene) {
        Scene fine = scene.avec(Antialias.coins(32, 0), 0);
        return ImageLineaire.de(LancerSurveille.preparer(fine, LARGEUR, HAUTEUR, false), Gabarit.PROFONDEUR, 2);
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
            Gabarit gabarit = new Gabarit(scene, LARGEUR, HAUTEUR, 1);
            for (int reflets : new int[] {0, 5}) {
                ImageLineaire image = ImageLineaire.de(LancerSurveille.preparer(scene, LARGEUR, HAUTEUR, false), reflets, 2);
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
        assertTrue(Intervalle.deLaRacine(new Gabarit(scene, LARGEUR, HAUTEUR, 1).carres(verite)).valeur < 0.5);
    }

    @Test
    void uneSceneAuHasardNeDependQueDeSaGraine() {
        assertEquals(description(SceneAuHasard.de(7)), description(SceneAuHasard.de(7)));
        assertNotEquals(description(SceneAuHasard.de(7)), description(SceneAuHasard.de(8)));
    }

    private static String description(Scene scene) {
        return new Lancer(scene, new Camera(40, 30)).getCouleurPixel(20, 15, 5) + " " + scene.getObjets().size();
    }

    @Test
    void laPromesseDUneSceneSimpleEstTenueEtDecrite() {
        Scene scene = SceneAuHasard.de(3);
        PromesseAuto promesse = new PromesseAuto("essai", scene, LARGEUR, HAUTEUR, new Gabarit(scene, LARGEUR, HAUTEUR, 1), 8);
        assertTrue(promesse.promise && promesse.estTenue(), promesse.csv());
        assertTrue(promesse.csv().startsWith("essai,8.0,\"[Antialias] n="), promesse.csv());
        // une virgule dans une colonne, entre guillemets
        assertEquals(PromesseAuto.COLONNES.split(",").length + 1, promesse.csv().split(",").length);
        List<PromesseAuto> seule = Arrays.asList(promesse);
        assertTrue(PromesseAuto.bilan(seule).startsWith("erreur voulue tenue 1 fois sur 1 ; promise 1 fois, dont tenue 1,"));
        assertFalse(PromesseAuto.bilan(seule).contains("NaN"));
        // une image de 56 × 42 n'a pas droit à la moitié de son dessin, mais à ce que rien ne demande en 0,2 s
        assertTrue(PromesseAuto.bilan(seule).matches(".*, et au pire 0\\.\\d\\d fois ce qui leur est permis"), PromesseAuto.bilan(seule));
    }
}
