package lancer.mesures.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import lancer.mesures.Intervalle;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.ui.RectangleEdge;
import org.junit.jupiter.api.Test;

/** L'apparence des courbes. */
class StyleTest {

    private final BufferedImage image = new BufferedImage(600, 400, BufferedImage.TYPE_INT_RGB);
    private final Graphics2D g = image.createGraphics();

    @Test
    void lesNombresSontALaFrancaiseSansChiffreDeTrop() {
        assertEquals("0", Style.nombre(0));
        assertEquals("0,5", Style.nombre(0.5));
        assertEquals("12,3", Style.nombre(12.345));
        assertEquals("1\u00A0000\u00A0000", Style.nombre(1e6));
        assertEquals("0,001", Style.nombre(0.001));
        assertEquals("10⁻⁵", Style.nombre(1e-5));
        assertEquals("2,5 × 10⁻¹²", Style.nombre(2.5e-12));
        assertEquals("\u22123", Style.nombre(-3));
        assertEquals("2,1", Style.arrondi(2.08));
        assertEquals("0,022", Style.arrondi(0.02151));
        assertEquals("24", Style.arrondi(23.7));
        assertEquals("1", Style.arrondi(0.999));
    }

    private List<String> graduations(double min, double max) {
        return new Axe("", min, max).refreshTicks(g, new AxisState(), new Rectangle2D.Double(0, 0, 600, 400), RectangleEdge.LEFT)
                .stream().map(NumberTick::getText).collect(Collectors.toList());
    }

    @Test
    void unAxeLogarithmiqueEstGradueDeNombresRondsDAutantMoinsQuIlEstLong() {
        assertEquals(Arrays.asList("0,5", "1", "2", "5", "10", "20"), graduations(0.4, 25));
        assertEquals(Arrays.asList("2", "2,5", "3", "4"),
                graduations(2, 4.6));
        assertEquals(Arrays.asList("10⁻³", "0,01", "0,1", "1", "10", "100"), graduations(0.001, 100));
    }

    @Test
    void uneEtiquetteNEstJamaisSurUneAutreNiSurUnPointNiHorsDuCadre() {
        effacer();
        Etiquettes noms = new Etiquettes(g, new Rectangle2D.Double(100, 100, 200, 120));
        noms.reserver(200, 150, FormeDePoint.DEMI_COTE);
        int ecrites = 0;
        for (int k = 0; k < 60; k++) {
            ecrites += noms.ecrire("étiquette", 200, 150, 0, Style.ETIQUETTE, Color.BLACK, true) ? 1 : 0;
        }
        assertTrue(ecrites >= 2 && ecrites < 20, ecrites + " étiquettes dans un si petit cadre");
        for (int y = 0; y < 400; y++) {
            for (int x = 0; x < 600; x++) {
                boolean dehors = x < 99 || x > 301 || y < 99 || y > 221;
                boolean surLePoint = Math.abs(x - 200) < 3 && Math.abs(y - 150) < 3;
                assertFalse((dehors || surLePoint) && image.getRGB(x, y) != -1, "(" + x + ", " + y + ")");
            }
        }
    }

    private void effacer() {
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, 600, 400);
    }

    /** Les pixels gris d'une courbe dont un repère porte ce nom. */
    private long gris(String repere, Marque... marques) {
        effacer();
        new Volet("", "", "").serie(new Serie("", Style.VERT, FormeDePoint.CARRE, true, Arrays.asList(marques))).repere(1, repere)
                .dessiner(g, new Rectangle2D.Double(0, 0, 600, 400), 0);
        return Arrays.stream(image.getRGB(0, 0, 600, 400, null, 0, 600)).filter(p -> p == Style.GRIS.getRGB()).count();
    }

    @Test
    void unRepereASonNomMemeSiSaDroiteEstPrise() {
        Marque[] haut = {Marque.en(1, 30), Marque.en(99, 30)};
        Marque[] descend = {Marque.en(1, 30), Marque.en(60, 30), Marque.en(60, 0.1), Marque.en(99, 30), Marque.en(99, 0.1)};
        for (Marque[] marques : new Marque[][] {haut, descend}) {
            assertTrue(gris("le nom", marques) > gris("", marques) + 20);
        }
    }

    @Test
    void unGuillemetNEstPasSepareDeSonMot() {
        double une = Style.texte(g, "un", Style.TEXTE, Color.BLACK, 0, 0, 500, false);
        // « un / « mot » : / 2 fois »
        assertEquals(3 * une, Style.texte(g, "un « mot » : 2 fois", Style.TEXTE, Color.BLACK, 0, 0, 100, false), 0.1 * une);
    }

    @Test
    void toutesLesPlanchesOntLaMemeTailleEtDesMarquesDeToutesLesCouleursDeLaLegende() {
        Serie serie = new Serie("mesures", Style.VERMILLON, FormeDePoint.LOSANGE, true,
                Arrays.asList(new Marque(new Intervalle(1, 0.8, 1.2), Intervalle.exact(10)).nommee("un"), Marque.en(10, 1).creuse(),
                        Marque.en(100, 0.4).cerclee()));
        Volet volet = new Volet("Le constat", "x, en ms", "y, en pas").serie(serie).enHaut(2, "x, au second").mieux()
                .serie(new Serie("un fond", Style.FRONT, FormeDePoint.AUCUNE, true, serie.marques)).repere(5, "un repère");
        BufferedImage planche = new Planche("Un titre", "une note").volet(volet).volet(volet).dessiner();
        assertEquals(Style.LARGEUR, planche.getWidth());
        assertEquals(Style.HAUTEUR, planche.getHeight());
        assertEquals(800, new Planche("Un titre", "").volet(volet).taille(800, 500).dessiner().getWidth());
        int[] pixels = planche.getRGB(0, 0, planche.getWidth(), planche.getHeight(), null, 0, planche.getWidth());
        for (Color couleur : new Color[] {Style.VERMILLON, Style.FRONT, Style.GRIS, Style.NOIR}) {
            assertTrue(Arrays.stream(pixels).filter(p -> p == couleur.getRGB()).count() > 100, couleur.toString());
        }
    }
}
