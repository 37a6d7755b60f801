package lancer.mesures.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import lancer.mesures.Intervalle;
import org.junit.jupiter.api.Test;

/** L'apparence des figures. */
class PlancheTest {

    private static final List<Volet.Point> POINTS = List.of(
            new Volet.Point(1, new Intervalle(10, 8, 12), "le nom"),
            new Volet.Point(10, 1), new Volet.Point(100, 0.4));

    private static long pixels(BufferedImage image, int couleur) {
        int[] pixels = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        return Arrays.stream(pixels).filter(p -> (p & 0xFFFFFF) == couleur).count();
    }

    @Test
    void desVoletsEnRangeesMontrentChaqueSerieDansSaCouleurEtLeRepere() {
        Volet volet = new Volet("Un titre", "x", "y").serie("une", true, POINTS).serie("autre", true,
                List.of(new Volet.Point(2, 0.5), new Volet.Point(50, 8))).repere(5, "5");
        BufferedImage planche = new Planche(2, 500).volet(volet).volet(volet).volet(volet).dessiner();
        assertEquals(Planche.LARGEUR, planche.getWidth());
        assertEquals(1000, planche.getHeight());
        for (int couleur : new int[] {0xD55E00, 0x0072B2, 0x707070}) {
            assertTrue(pixels(planche, couleur) > 100, Integer.toHexString(couleur));
        }
    }

    @Test
    void desAxesOrdinairesContiennentZeroEtDesVoletsVoisinsOntLesMemes() {
        Volet grand = new Volet("", "x", "y").xOrdinaire().yOrdinaire().serie("une", false, POINTS);
        Volet petit = new Volet("", "x", "y").xOrdinaire().yOrdinaire().serie("une", false, POINTS.subList(0, 2));
        Volet.memesAxes(List.of(grand, petit));
        assertEquals(0, petit.graphique().getXYPlot().getDomainAxis().getLowerBound());
        assertTrue(petit.graphique().getXYPlot().getDomainAxis().getUpperBound() >= 100);
    }
}
