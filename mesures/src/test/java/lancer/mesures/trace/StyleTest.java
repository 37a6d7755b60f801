package lancer.mesures.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.text.AttributedCharacterIterator;
import java.text.CharacterIterator;
import java.util.Arrays;
import lancer.mesures.Intervalle;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogTick;
import org.jfree.chart.block.RectangleConstraint;
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

    private String graduations(double min, double max) throws IOException {
        StringBuilder textes = new StringBuilder();
        for (Object graduation : new Axe("", min, max).refreshTicks(g, new AxisState(), new Rectangle2D.Double(0, 0, 600, 400),
                RectangleEdge.LEFT)) {
            AttributedCharacterIterator lettres = ((LogTick) graduation).getAttributedLabel().getIterator();
            textes.append(textes.length() > 0 ? " " : "");
            for (char c = lettres.first(); c != CharacterIterator.DONE; c = lettres.next()) {
                textes.append(c);
            }
        }
        return textes.toString();
    }

    @Test
    void unAxeLogarithmiqueEstGradueDePuissancesDeDeuxOuDeDixDAutantPlusEspaceesQuIlEstLong() throws IOException {
        assertEquals("0,5 1 2 4 8 16", graduations(0.4, 25));
        assertEquals("10⁻³ 0,01 0,1 1 10 100", graduations(0.00099, 101));
        assertEquals("10⁻¹⁴ 10⁻¹² 10⁻¹⁰ 10⁻⁸ 10⁻⁶ 10⁻⁴ 0,01 1", graduations(0.99e-14, 1.01));
    }

    /** Les pixels de cette couleur d'un volet dont le point porte ce nom, et le repère celui-ci. */
    private long encre(Color couleur, String nom, String repere) {
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, 600, 400);
        new Volet("", "", "").serie(new Serie("", Style.VERT, FormeDePoint.CARRE, true, Arrays.asList(Marque.en(1, 3).nommee(nom),
                Marque.en(9, 30)))).repere(1, repere).graphique().draw(g, new Rectangle2D.Double(0, 0, 600, 400));
        return Arrays.stream(image.getRGB(0, 0, 600, 400, null, 0, 600)).filter(p -> p == couleur.getRGB()).count();
    }

    @Test
    void unPointEtUnRepereOntLeurNom() {
        assertTrue(encre(Style.VERT.darker(), "le nom", "") > encre(Style.VERT.darker(), "", "") + 20);
        assertTrue(encre(Style.GRIS, "", "le nom") > encre(Style.GRIS, "", "") + 20);
    }

    private double hauteur(String texte, double largeur) {
        return Style.titre(texte, Style.TEXTE, Color.BLACK).arrange(g, RectangleConstraint.NONE.toFixedWidth(largeur)).getHeight();
    }

    @Test
    void unGuillemetNEstPasSepareDeSonMot() {
        double une = hauteur("un", 500);
        // « un / « mot » : / 2 fois »
        assertEquals(3 * une, hauteur("un « mot » : 2 fois", 100), 0.1 * une);
    }

    @Test
    void toutesLesPlanchesOntLaMemeTailleEtDesMarquesDeToutesLesCouleursDeLaLegende() {
        Serie serie = new Serie("mesures", Style.VERMILLON, FormeDePoint.LOSANGE, true,
                Arrays.asList(new Marque(new Intervalle(1, 0.8, 1.2), Intervalle.exact(10)).nommee("un"), Marque.en(10, 1).creuse(),
                        Marque.en(100, 0.4)));
        Volet volet = new Volet("Le constat", "x, en ms", "y, en pas").serie(serie).enHaut(2, "x, au second")
                .serie(new Serie("", Style.NOIR, FormeDePoint.ANNEAU, false, serie.marques))
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
