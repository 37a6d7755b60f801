package lancer.mesures.trace;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Paint;
import java.awt.Stroke;
import java.text.DecimalFormat;
import java.util.List;
import lancer.mesures.Intervalle;
import lancer.mesures.Nombres;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.StandardChartTheme;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.labels.ItemLabelAnchor;
import org.jfree.chart.labels.ItemLabelPosition;
import org.jfree.chart.labels.XYItemLabelGenerator;
import org.jfree.chart.plot.DefaultDrawingSupplier;
import org.jfree.chart.plot.SeriesRenderingOrder;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.Range;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;

/**
 * Un graphique : des séries entre deux axes, logarithmiques ou ordinaires. Les places sont celles que choisit JFreeChart ; les couleurs se
 * distinguent pour un daltonien (M. Okabe et K. Ito, <i>Color Universal Design</i>, 2008).
 */
public final class Volet {

    /** Couleurs des séries, dans l'ordre où elles sont ajoutées. */
    private static final Paint[] COULEURS = {new Color(0xD55E00), new Color(0x0072B2), new Color(0xE69F00), new Color(0x009E73),
        new Color(0xCC79A7), new Color(0x56B4E9), new Color(0x222222), new Color(0xF0E442)};

    private static final Color GRIS = new Color(0x707070);
    private static final Color GRILLE = new Color(0xD8D8D8);

    /** Rapport des bornes d'un axe au-delà duquel il est gradué par puissances de dix, et non de deux. */
    private static final double LONG = 1000;

    private static final int GRADUATIONS = 8;

    /** Plus petite étendue d'un axe, et celle qu'il a relativement à sa plus grande valeur. */
    private static final double ETENDUE = 1e-8;

    /** Les courbes descendent vers la droite : les noms de la première sont du côté libre à droite, ceux de la suivante à gauche. */
    private static final ItemLabelPosition[] COTES = {new ItemLabelPosition(ItemLabelAnchor.OUTSIDE2, TextAnchor.BOTTOM_LEFT),
        new ItemLabelPosition(ItemLabelAnchor.OUTSIDE8, TextAnchor.TOP_RIGHT),
        new ItemLabelPosition(ItemLabelAnchor.OUTSIDE4, TextAnchor.TOP_LEFT)};

    /** Largeur du trait de la dernière série, en pixels, et ce que chaque série d'avant a de plus. */
    private static final int TRAIT = 3;
    private static final int SURPLUS = 2;

    private final XYIntervalSeriesCollection series = new XYIntervalSeriesCollection();
    private final JFreeChart graphique;
    private final XYPlot plot;

    /** Un point mesuré, la barre de son intervalle, et le texte écrit à côté, vide s'il n'y en a pas. */
    public static final class Point {

        private final double x;
        private final Intervalle y;
        private final String texte;

        public Point(double x, Intervalle y, String texte) {
            this.x = x;
            this.y = y.montrable();
            this.texte = texte;
        }

        public Point(double x, double y) {
            this(x, Intervalle.exact(y), "");
        }

        /** Faux d'une ordonnée nulle, qu'un axe logarithmique n'a pas. */
        public boolean seMontre() {
            return y.valeur > 0;
        }
    }

    public Volet(String titre, String nomX, String nomY) {
        plot = new XYPlot(series, new LogAxis(nomX), new LogAxis(nomY), new XYErrorRenderer());
        plot.setDrawingSupplier(new DefaultDrawingSupplier(COULEURS, DefaultDrawingSupplier.DEFAULT_OUTLINE_PAINT_SEQUENCE,
                new Stroke[] {new BasicStroke(3)}, DefaultDrawingSupplier.DEFAULT_OUTLINE_STROKE_SEQUENCE,
                DefaultDrawingSupplier.DEFAULT_SHAPE_SEQUENCE));
        // la dernière série est dessinée sur les autres, d'un trait plus fin : aucune ne se cache
        plot.setSeriesRenderingOrder(SeriesRenderingOrder.FORWARD);
        graphique = new JFreeChart(titre, plot);
    }

    /** Remplace l'axe logarithmique des abscisses par un axe ordinaire, qui contient 0. */
    public Volet xOrdinaire() {
        plot.setDomainAxis(ordinaire(plot.getDomainAxis().getLabel()));
        return this;
    }

    /** Remplace l'axe logarithmique des ordonnées par un axe ordinaire, qui contient 0. */
    public Volet yOrdinaire() {
        plot.setRangeAxis(ordinaire(plot.getRangeAxis().getLabel()));
        return this;
    }

    private static NumberAxis ordinaire(String nom) {
        NumberAxis axe = new NumberAxis(nom);
        axe.setAutoRangeIncludesZero(true);
        return axe;
    }

    JFreeChart graphique() {
        StandardChartTheme theme = new StandardChartTheme("mesures");
        theme.setExtraLargeFont(new Font(Font.SANS_SERIF, Font.BOLD, 28));
        theme.setLargeFont(new Font(Font.SANS_SERIF, Font.PLAIN, 24));
        theme.setRegularFont(new Font(Font.SANS_SERIF, Font.PLAIN, 22));
        theme.setSmallFont(new Font(Font.SANS_SERIF, Font.PLAIN, 20));
        theme.setPlotBackgroundPaint(Color.WHITE);
        theme.setDomainGridlinePaint(GRILLE);
        theme.setRangeGridlinePaint(GRILLE);
        theme.setDrawingSupplier(plot.getDrawingSupplier());
        theme.apply(graphique);
        if (series.getSeriesCount() == 1) {
            graphique.removeLegend();
        }
        for (int k = 0; k < series.getSeriesCount(); k++) {
            plot.getRenderer().setSeriesStroke(k, new BasicStroke(TRAIT + SURPLUS * (series.getSeriesCount() - 1 - k)));
        }
        graduer(plot.getDomainAxis());
        graduer(plot.getRangeAxis());
        return graphique;
    }

    /** Ajoute une série, si elle a des points. @param reliee vrai si un trait les joint, dans l'ordre donné */
    public Volet serie(String nom, boolean reliee, List<Point> points) {
        if (points.isEmpty()) {
            return this;
        }
        int rang = series.getSeriesCount();
        XYIntervalSeries serie = new XYIntervalSeries(nom, false, true);
        points.forEach(p -> serie.add(p.x, p.x, p.x, p.y.valeur, p.y.min, p.y.max));
        // l'étendue la plus petite que JFreeChart donne à un axe, 1e-8, dépasse toutes les valeurs de certains
        double max = points.stream().mapToDouble(p -> p.y.valeur).max().getAsDouble();
        plot.getRangeAxis().setAutoRangeMinimumSize(Math.min(ETENDUE, ETENDUE * max));
        series.addSeries(serie);
        XYErrorRenderer rendu = (XYErrorRenderer) plot.getRenderer();
        XYItemLabelGenerator textes = (donnees, s, k) -> points.get(k).texte;
        rendu.setSeriesItemLabelGenerator(rang, textes);
        rendu.setSeriesItemLabelsVisible(rang, true);
        rendu.setSeriesPositiveItemLabelPosition(rang, COTES[rang % COTES.length]);
        rendu.setSeriesLinesVisible(rang, Boolean.valueOf(reliee));
        rendu.setSeriesItemLabelPaint(rang, COULEURS[rang % COULEURS.length]);
        return this;
    }

    /** Ajoute une droite horizontale, et son nom, au-dessus. */
    public Volet repere(double y, String nom) {
        return repere(y, nom, RectangleAnchor.TOP_RIGHT, TextAnchor.BOTTOM_RIGHT);
    }

    /** De même, le nom au-dessous. */
    public Volet repereNommeDessous(double y, String nom) {
        return repere(y, nom, RectangleAnchor.BOTTOM_RIGHT, TextAnchor.TOP_RIGHT);
    }

    private Volet repere(double y, String nom, RectangleAnchor place, TextAnchor coin) {
        ValueMarker repere = new ValueMarker(y, GRIS, new BasicStroke(2));
        repere.setLabel(nom);
        repere.setLabelFont(new Font(Font.SANS_SERIF, Font.PLAIN, 20));
        repere.setLabelPaint(GRIS);
        repere.setLabelBackgroundColor(Color.WHITE);
        repere.setLabelAnchor(place);
        repere.setLabelTextAnchor(coin);
        plot.addRangeMarker(repere, Layer.BACKGROUND);
        return this;
    }

    /** Fait décroître les abscisses vers la droite : les cas difficiles sont à droite. */
    public Volet versZero() {
        plot.getDomainAxis().setInverted(true);
        return this;
    }

    /** Dit si un point d'une série est entre les axes. */
    boolean aUnPoint() {
        for (int s = 0; s < series.getSeriesCount(); s++) {
            for (int k = 0; k < series.getItemCount(s); k++) {
                if (plot.getDomainAxis().getRange().contains(series.getXValue(s, k))
                        && plot.getRangeAxis().getRange().contains(series.getYValue(s, k))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Donne les mêmes axes à ces volets. */
    public static void memesAxes(List<Volet> volets) {
        Range x = null;
        Range y = null;
        for (Volet v : volets) {
            x = Range.combine(x, v.plot.getDomainAxis().getRange());
            y = Range.combine(y, v.plot.getRangeAxis().getRange());
        }
        for (Volet v : volets) {
            v.plot.getDomainAxis().setRange(x);
            v.plot.getRangeAxis().setRange(y);
        }
    }

    private static void graduer(ValueAxis axe) {
        double rapport = axe.getUpperBound() / axe.getLowerBound();
        if (axe instanceof NumberAxis) {
            ((NumberAxis) axe).setNumberFormatOverride(Nombres.format(2));
        } else if (rapport < LONG) {
            ((LogAxis) axe).setBase(2);
            ((LogAxis) axe).setNumberFormatOverride(Nombres.format(5));
            ((LogAxis) axe).setTickUnit(new NumberTickUnit(1));
        } else {
            ((LogAxis) axe).setTickUnit(new NumberTickUnit(Math.ceil(Math.log10(rapport) / GRADUATIONS), new DecimalFormat("0")));
        }
    }
}
