package lancer.mesures.trace;

import java.awt.Color;
import java.awt.Paint;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.AxisLocation;
import org.jfree.chart.axis.AxisSpace;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.Range;
import org.jfree.data.general.DatasetUtils;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;

/** Séries entre deux axes logarithmiques : une partie d'une {@link Planche}. */
public final class Volet {

    /** Demi-distance d'un point à son nom. */
    private static final double DEMI_COTE = 7;

    /** Largeur des ordonnées et de leur nom. */
    private static final double GAUCHE = 120;

    private final String constat;
    private final String nomX;
    private final String nomY;
    private final List<Serie> series = new ArrayList<>();
    private final Map<Double, String> niveaux = new LinkedHashMap<>();
    private boolean versZero;
    private boolean lineaire;

    /** Abscisse qui vaut 1 sur l'échelle du haut, 0 sans cette échelle ; nom de cette échelle. */
    private double un;
    private String nomHaut;

    /** Étendue supplémentaire des axes, pour qu'ils soient ceux d'autres volets. */
    private Range autresX;
    private Range autresY;

    /** @param constat ce que montre le volet ; vide si le titre de la planche le dit */
    public Volet(String constat, String nomX, String nomY) {
        this.constat = constat;
        this.nomX = nomX;
        this.nomY = nomY;
    }

    /** Ajoute une échelle en haut, où cette abscisse vaut 1. Une barre peut alors sortir du cadre, mais pas un point. */
    public Volet enHaut(double abscisse, String nom) {
        un = abscisse;
        nomHaut = nom;
        return this;
    }

    /** Remplace l'axe logarithmique des abscisses par un axe ordinaire. */
    public Volet lineaire() {
        lineaire = true;
        return this;
    }

    /** Donne les mêmes axes à ces volets. */
    public static void memesAxes(List<Volet> volets) {
        Range x = null;
        Range y = null;
        for (Volet v : volets) {
            x = Range.combine(x, DatasetUtils.iterateDomainBounds(v.donnees(), v.un == 0));
            y = Range.combine(y, DatasetUtils.iterateRangeBounds(v.donnees(), true));
        }
        for (Volet v : volets) {
            v.autresX = x;
            v.autresY = y;
        }
    }

    /** Fait décroître les abscisses vers la droite : les cas difficiles sont à droite. */
    public Volet versZero() {
        versZero = true;
        return this;
    }

    /** Ajoute une série, si elle a des marques. */
    public Volet serie(Serie serie) {
        if (!serie.marques.isEmpty()) {
            series.add(serie);
        }
        return this;
    }

    /** Ajoute une droite horizontale en pointillé, et son nom. */
    public Volet repere(double y, String nom) {
        niveaux.put(y, nom);
        return this;
    }

    JFreeChart graphique() {
        JFreeChart graphique = new JFreeChart(null, null, plot(), false);
        graphique.setBackgroundPaint(null);
        graphique.setPadding(new RectangleInsets(10, 0, 0, 16));
        if (!constat.isEmpty()) {
            graphique.setTitle(Style.titre(constat, Style.CONSTAT, Style.ENCRE));
        }
        return graphique;
    }

    private XYPlot plot() {
        // JFreeChart peint les séries de la dernière à la première : un trait large reste derrière les points
        series.sort(Comparator.comparing(s -> s.forme == FormeDePoint.AUCUNE));
        Range etendueX = Range.combine(autresX, DatasetUtils.iterateDomainBounds(donnees(), un == 0));
        Range etendueY = Range.combine(autresY, DatasetUtils.iterateRangeBounds(donnees(), true));
        for (double niveau : niveaux.keySet()) {
            etendueY = Range.expandToInclude(etendueY, niveau);
        }
        ValueAxis axeX = lineaire ? new NumberAxis(nomX) : axe(nomX, etendueX);
        axeX.setInverted(versZero);
        XYPlot plot = new XYPlot(donnees(), axeX, axe(nomY, etendueY), new Points(series));
        plot.setBackgroundPaint(null);
        // deux volets l'un sous l'autre ont ainsi les mêmes abscisses
        AxisSpace gauche = new AxisSpace();
        gauche.setLeft(GAUCHE);
        plot.setFixedRangeAxisSpace(gauche);
        plot.setOutlinePaint(Style.GRIS);
        plot.setDomainGridlinePaint(Style.GRILLE);
        plot.setRangeGridlinePaint(Style.GRILLE);
        plot.setDomainGridlineStroke(Style.TRAIT_FIN);
        plot.setRangeGridlineStroke(Style.TRAIT_FIN);
        habiller(axeX);
        habiller(plot.getRangeAxis());
        if (un > 0) {
            plot.setDomainAxis(1, habiller(new Axe(nomHaut, axeX.getLowerBound() / un, axeX.getUpperBound() / un)));
            plot.setDomainAxisLocation(1, AxisLocation.TOP_OR_LEFT);
        }
        niveaux.forEach((y, nom) -> {
            ValueMarker repere = new ValueMarker(y, Style.GRIS, Style.POINTILLE);
            repere.setLabel(nom);
            repere.setLabelFont(Style.ETIQUETTE);
            repere.setLabelPaint(Style.GRIS);
            repere.setLabelBackgroundColor(Color.WHITE);
            // les courbes du temps descendent vers la droite
            repere.setLabelAnchor(un > 0 ? RectangleAnchor.BOTTOM_LEFT : RectangleAnchor.TOP_RIGHT);
            repere.setLabelTextAnchor(un > 0 ? TextAnchor.TOP_LEFT : TextAnchor.BOTTOM_RIGHT);
            plot.addRangeMarker(repere, Layer.BACKGROUND);
        });
        return plot;
    }

    private static ValueAxis habiller(ValueAxis axe) {
        axe.setLabelFont(Style.TEXTE);
        axe.setLabelPaint(Style.ENCRE);
        axe.setTickLabelFont(Style.TEXTE);
        axe.setTickLabelPaint(Style.ENCRE);
        axe.setAxisLinePaint(Style.GRIS);
        axe.setTickMarkPaint(Style.GRIS);
        axe.setMinorTickMarksVisible(false);
        return axe;
    }

    /** Un axe plus long que l'étendue de ses marques, dont le dessin doit tenir aussi. */
    private static Axe axe(String nom, Range montre) {
        double min = montre.getLowerBound();
        double max = montre.getUpperBound();
        double jeu = Math.max(1 + 0.2 * Math.min(1, max / min - 1), Math.pow(max / min, 0.04));
        return new Axe(nom, min / jeu, max * jeu);
    }

    private XYIntervalSeriesCollection donnees() {
        XYIntervalSeriesCollection donnees = new XYIntervalSeriesCollection();
        for (Serie serie : series) {
            XYIntervalSeries points = new XYIntervalSeries(serie.nom, false, true);
            serie.marques.forEach(m -> points.add(m.x.valeur, m.x.min, m.x.max, m.y.valeur, m.y.min, m.y.max));
            donnees.addSeries(points);
        }
        return donnees;
    }

    /** Peint les traits, puis les points et leurs barres, en creux pour les points sans intérêt. */
    private static final class Points extends XYErrorRenderer {

        private static final long serialVersionUID = 1;

        private final transient List<Serie> partie;

        Points(List<Serie> partie) {
            this.partie = partie;
            setErrorStroke(Style.TRAIT_FIN);
            setLegendLine(new Line2D.Double(-26, 0, 26, 0));
            setCapLength(10);
            setItemLabelAnchorOffset(DEMI_COTE);
            setUseFillPaint(true);
            for (int s = 0; s < partie.size(); s++) {
                Serie serie = partie.get(s);
                boolean points = serie.forme != FormeDePoint.AUCUNE;
                setSeriesPaint(s, serie.couleur);
                setSeriesFillPaint(s, serie.couleur);
                setSeriesLinesVisible(s, Boolean.valueOf(serie.reliee));
                setSeriesShapesVisible(s, points);
                setSeriesShape(s, serie.forme.dessin);
                setSeriesShapesFilled(s, serie.forme != FormeDePoint.ANNEAU);
                setSeriesItemLabelsVisible(s, true);
                setSeriesItemLabelGenerator(s, (donnees, rang, point) -> serie.marques.get(point).etiquette);
                setSeriesItemLabelPaint(s, serie.couleur.darker());
                setSeriesItemLabelFont(s, Style.ETIQUETTE);
                setSeriesPositiveItemLabelPosition(s, serie.place);
                // un trait plus large reste visible derrière les autres
                setSeriesStroke(s, points ? Style.TRAIT : Style.TRAIT_FRONT);
                setSeriesOutlineStroke(s, Style.TRAIT);
                setSeriesVisibleInLegend(s, !serie.nom.isEmpty());
            }
        }

        @Override
        public Paint getItemFillPaint(int s, int point) {
            return partie.get(s).marques.get(point).pleine ? partie.get(s).couleur : Color.WHITE;
        }
    }
}
