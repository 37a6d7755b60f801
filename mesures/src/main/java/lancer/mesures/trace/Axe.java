package lancer.mesures.trace;

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
 * Un axe logarithmique aux graduations rondes (1, 2, 5, moins s'il est long, de simples pas s'il est court), écrites à la
 * française. Il peut garder, au bout, une place pour zéro.
 */
final class Axe extends LogAxis {

    private static final long serialVersionUID = 1;

    /** Rapport des bornes au-dessous duquel les graduations sont équidistantes, puis au-dessus duquel elles se raréfient. */
    private static final double COURT = 6;
    private static final double LONG = 250;
    private static final double TRES_LONG = 20000;
    private static final double IMMENSE = 2e9;

    /** Graduations d'un axe court, à peu près. */
    private static final int NOMBRE = 6;

    /** Nombre qui s'écrit comme une puissance de dix, faute de place. */
    private static final double GRAND = 1e4;

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
        setLabelFont(Style.AXE);
        setLabelPaint(Style.ENCRE);
        setTickLabelFont(Style.GRADUATION);
        setTickLabelPaint(Style.ENCRE);
        setAxisLinePaint(Style.GRIS);
        setTickMarkPaint(Style.GRIS);
    }

    /** Où dessiner cette valeur : zéro, et ce qui n'en diffère guère, à la place de zéro. */
    double place(double valeur) {
        return zero > 0 && valeur < min ? zero : valeur;
    }

    /** Où commence la bande de zéro. */
    double seuilDeZero() {
        return zero > 0 ? min : 0;
    }

    @Override
    public List<NumberTick> refreshTicks(Graphics2D g2, AxisState state, Rectangle2D dataArea, RectangleEdge edge) {
        boolean horizontal = RectangleEdge.isTopOrBottom(edge);
        TextAnchor ancre = horizontal ? TextAnchor.TOP_CENTER : TextAnchor.CENTER_RIGHT;
        List<NumberTick> graduations = new ArrayList<>();
        for (double valeur : valeurs()) {
            boolean puissance = valeur >= GRAND || max / min > IMMENSE && valeur < 0.1;
            String texte = puissance ? Style.puissance(valeur) : Style.nombre(valeur);
            graduations.add(new NumberTick(TickType.MAJOR, valeur, texte, ancre, TextAnchor.CENTER, 0));
        }
        if (zero > 0) {
            graduations.add(new NumberTick(TickType.MAJOR, zero, "0", ancre, TextAnchor.CENTER, 0));
        }
        return graduations;
    }

    private List<Double> valeurs() {
        List<Double> valeurs = new ArrayList<>();
        if (max / min < COURT) {
            double pas = pas((max - min) / NOMBRE);
            for (long k = (long) Math.ceil(min / pas); k * pas <= max; k++) {
                valeurs.add(k * pas);
            }
            return valeurs;
        }
        int dernier = (int) Math.floor(Math.log10(max) + 1e-9);
        int saut = max / min > IMMENSE ? 2 : 1;
        for (int e = Math.floorDiv((int) Math.floor(Math.log10(min)), saut) * saut; e <= dernier; e += saut) {
            for (int m : multiples()) {
                double valeur = m * Math.pow(10, e);
                if (valeur >= min && valeur <= max && (zero == 0 || valeur > 1.5 * min)) {
                    valeurs.add(valeur);
                }
            }
        }
        return valeurs;
    }

    /** Ce qui est gradué dans chaque puissance de dix : plus l'axe est long, moins il y en a. */
    private int[] multiples() {
        return max / min > TRES_LONG ? new int[] {1} : max / min > LONG ? new int[] {1, 3} : new int[] {1, 2, 5};
    }

    /** Le premier pas rond (1, 2 ou 5, fois une puissance de dix) qui ne soit pas plus petit. */
    private static double pas(double auMoins) {
        double puissance = Math.pow(10, Math.floor(Math.log10(auMoins)));
        double m = auMoins / puissance;
        return puissance * (m <= 1 ? 1 : m <= 2 ? 2 : m <= 5 ? 5 : 10);
    }
}
