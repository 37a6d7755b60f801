package lancer.mesures.trace;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.axis.TickType;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;

/** Un axe logarithmique à graduations rondes, écrites à la française. */
final class Axe extends LogAxis {

    private static final long serialVersionUID = 1;

    /** Nombre maximal de graduations. */
    private static final int ASSEZ = 8;

    /** Graduations de chaque puissance de dix, puis d'une sur deux, d'une sur trois… : de plus en plus espacées. */
    private static final double[][] MULTIPLES = {{1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8}, {1, 1.5, 2, 3, 5}, {1, 2, 5}, {1, 3}, {1}};

    /** @param min plus grand que 0 */
    Axe(String nom, double min, double max) {
        super(nom);
        setSmallestValue(Math.min(1e-300, min));
        setRange(min, max);
    }

    @Override
    public List<NumberTick> refreshTicks(Graphics2D g2, AxisState state, Rectangle2D dataArea, RectangleEdge edge) {
        boolean horizontal = RectangleEdge.isTopOrBottom(edge);
        TextAnchor ancre = !horizontal ? TextAnchor.CENTER_RIGHT : edge == RectangleEdge.TOP ? TextAnchor.BOTTOM_CENTER
                : TextAnchor.TOP_CENTER;
        FontMetrics mesures = g2.getFontMetrics(getTickLabelFont());
        List<NumberTick> graduations = new ArrayList<>();
        for (int finesse = 0; ; finesse++) {
            graduations.clear();
            for (double valeur : valeurs(finesse)) {
                String texte = valeur >= 1e4 || valeur < 1e-2 ? Style.puissance(valeur) : Style.nombre(valeur);
                graduations.add(new NumberTick(TickType.MAJOR, valeur, texte, ancre, TextAnchor.CENTER, 0));
            }
            double large = graduations.stream().mapToDouble(t -> mesures.stringWidth(t.getText()) + 20).max().orElse(0);
            if (graduations.size() <= ASSEZ && (!horizontal || graduations.size() * large < dataArea.getWidth())) {
                return graduations;
            }
        }
    }

    private List<Double> valeurs(int finesse) {
        double[] multiples = MULTIPLES[Math.min(finesse, MULTIPLES.length - 1)];
        int saut = Math.max(1, finesse - MULTIPLES.length + 2);
        List<Double> valeurs = new ArrayList<>();
        int premier = Math.floorDiv((int) Math.floor(Math.log10(getLowerBound())), saut) * saut;
        for (int e = premier; e <= Math.log10(getUpperBound()) + 1e-9; e += saut) {
            for (double m : multiples) {
                double valeur = e < 0 ? m / Math.pow(10, -e) : m * Math.pow(10, e);
                if (getRange().contains(valeur)) {
                    valeurs.add(valeur);
                }
            }
        }
        return valeurs;
    }
}
