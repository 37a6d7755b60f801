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

/**
 * Un axe logarithmique aux graduations rondes, autant que la place en permet, écrites à la française. Il peut garder, au bout, une
 * place pour zéro.
 */
final class Axe extends LogAxis {

    private static final long serialVersionUID = 1;

    /** Graduations, au plus. */
    private static final int ASSEZ = 8;

    /** Ce qui est gradué dans chaque puissance de dix, puis dans une sur deux, trois… : du plus serré au plus lâche. */
    private static final double[][] MULTIPLES = {{1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8}, {1, 1.5, 2, 3, 5}, {1, 2, 5}, {1, 3}, {1}};

    private final double min;
    private final double max;
    private final double zero;

    /**
     * @param nom et unité
     * @param min plus grand que 0
     * @param zero où dessiner zéro, avant {@code min} ; 0 s'il n'a pas de place
     */
    Axe(String nom, double min, double max, double zero) {
        super(nom);
        this.min = min;
        this.max = max;
        this.zero = zero;
        setSmallestValue(Math.min(1e-300, min));
        setRange(zero > 0 ? zero / 1.6 : min, max);
    }

    /** Où dessiner cette valeur : zéro, et ce qui n'en diffère guère, à la place de zéro. */
    double place(double valeur) {
        return zero > 0 && valeur < min ? zero : valeur;
    }

    @Override
    public List<NumberTick> refreshTicks(Graphics2D g2, AxisState state, Rectangle2D dataArea, RectangleEdge edge) {
        boolean horizontal = RectangleEdge.isTopOrBottom(edge);
        TextAnchor ancre = horizontal ? TextAnchor.TOP_CENTER : TextAnchor.CENTER_RIGHT;
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
                break;
            }
        }
        if (zero > 0) {
            graduations.add(new NumberTick(TickType.MAJOR, zero, "0", ancre, TextAnchor.CENTER, 0));
        }
        return graduations;
    }

    private List<Double> valeurs(int finesse) {
        double[] multiples = MULTIPLES[Math.min(finesse, MULTIPLES.length - 1)];
        int saut = Math.max(1, finesse - MULTIPLES.length + 2);
        List<Double> valeurs = new ArrayList<>();
        for (int e = Math.floorDiv((int) Math.floor(Math.log10(min)), saut) * saut; e <= Math.log10(max) + 1e-9; e += saut) {
            for (double m : multiples) {
                double valeur = e < 0 ? m / Math.pow(10, -e) : m * Math.pow(10, e);
                if (valeur >= min && valeur <= max && (zero == 0 || valeur > 1.5 * min)) {
                    valeurs.add(valeur);
                }
            }
        }
        return valeurs;
    }
}
