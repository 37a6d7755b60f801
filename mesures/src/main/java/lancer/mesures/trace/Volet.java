package lancer.mesures.trace;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.AxisLocation;
import org.jfree.chart.axis.AxisSpace;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.Range;
import org.jfree.data.general.DatasetUtils;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;

/** Séries entre deux axes logarithmiques : une partie d'une {@link Planche}. Le nom d'un point est près de lui, s'il y a la place. */
public final class Volet {

    private static final double RETRAIT = 8;

    /** Largeur des ordonnées et de leur nom. */
    private static final double GAUCHE = 120;

    private final String constat;
    private final String nomX;
    private final String nomY;
    private final List<Serie> fonds = new ArrayList<>();
    private final List<Serie> series = new ArrayList<>();
    private final Map<Double, String> niveaux = new LinkedHashMap<>();
    private boolean versZero;
    private boolean mieux;

    /** Abscisse qui vaut 1 sur l'échelle du haut, 0 sans cette échelle ; nom de cette échelle. */
    private double un;
    private String nomHaut;

    /** Étendue supplémentaire des axes, pour qu'ils soient ceux d'autres volets. */
    private Range autresX;
    private Range autresY;
    private Axe axeX;
    private Axe axeY;

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

    /** Ajoute une flèche en bas à gauche, vers les meilleures valeurs. */
    public Volet mieux() {
        mieux = true;
        return this;
    }

    /** Donne les mêmes axes à ces volets. */
    public static void memesAxes(List<Volet> volets) {
        Range x = null;
        Range y = null;
        for (Volet v : volets) {
            x = Range.combine(x, DatasetUtils.iterateDomainBounds(v.donnees(v.series), v.un == 0));
            y = Range.combine(y, DatasetUtils.iterateRangeBounds(v.donnees(v.series), true));
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
            (serie.forme == FormeDePoint.AUCUNE ? fonds : series).add(serie);
        }
        return this;
    }

    /** Ajoute une droite horizontale en pointillé, et son nom. */
    public Volet repere(double y, String nom) {
        niveaux.put(y, nom);
        return this;
    }

    /** Noms de la légende. */
    LegendItemCollection legende() {
        return plot().getLegendItems();
    }

    /** La hauteur de l'en-tête, pour cette largeur. */
    double enTete(Graphics2D g, double largeur) {
        return ecrire(g, 0, 0, largeur, false) + 14;
    }

    private double ecrire(Graphics2D g, double x, double y, double largeur, boolean vraiment) {
        return Style.texte(g, constat, Style.CONSTAT, Style.ENCRE, x, y, largeur - 2 * RETRAIT, vraiment);
    }

    /**
     * Dessine le volet dans ce rectangle.
     *
     * @param enTete hauteur de l'en-tête, la même pour tous les volets d'une rangée
     */
    void dessiner(Graphics2D g, Rectangle2D place, double enTete) {
        ecrire(g, place.getX() + RETRAIT, place.getY(), place.getWidth(), true);
        JFreeChart courbe = new JFreeChart(null, null, plot(), false);
        courbe.setBackgroundPaint(null);
        courbe.setPadding(new RectangleInsets(10, 0, 0, 16));
        ChartRenderingInfo info = new ChartRenderingInfo();
        courbe.draw(g, new Rectangle2D.Double(place.getX(), place.getY() + enTete, place.getWidth(), place.getHeight() - enTete), info);
        annoter(g, info.getPlotInfo().getDataArea());
    }

    private XYPlot plot() {
        XYIntervalSeriesCollection montrees = donnees(series);
        axes(montrees);
        // JFreeChart peint les séries de la dernière à la première : les fonds sont derrière
        XYPlot plot = new XYPlot(montrees, axeX, axeY, new Points(series));
        plot.setDataset(1, donnees(fonds));
        plot.setRenderer(1, new Points(fonds));
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
        if (un > 0) {
            Axe haut = new Axe(nomHaut, axeX.getLowerBound() / un, axeX.getUpperBound() / un);
            habiller(haut);
            plot.setDomainAxis(1, haut);
            plot.setDomainAxisLocation(1, AxisLocation.TOP_OR_LEFT);
        }
        niveaux.keySet().forEach(y -> plot.addRangeMarker(new ValueMarker(y, Style.GRIS, Style.POINTILLE), Layer.BACKGROUND));
        return plot;
    }

    private void axes(XYIntervalSeriesCollection montrees) {
        axeX = axe(nomX, Range.combine(autresX, DatasetUtils.iterateDomainBounds(montrees, un == 0)));
        axeX.setInverted(versZero);
        Range y = Range.combine(autresY, DatasetUtils.iterateRangeBounds(montrees, true));
        for (double niveau : niveaux.keySet()) {
            y = Range.expandToInclude(y, niveau);
        }
        axeY = axe(nomY, y);
        habiller(axeX);
        habiller(axeY);
    }

    private static void habiller(ValueAxis axe) {
        axe.setLabelFont(Style.TEXTE);
        axe.setLabelPaint(Style.ENCRE);
        axe.setTickLabelFont(Style.TEXTE);
        axe.setTickLabelPaint(Style.ENCRE);
        axe.setAxisLinePaint(Style.GRIS);
        axe.setTickMarkPaint(Style.GRIS);
        axe.setMinorTickMarksVisible(false);
    }

    /** Un axe plus long que l'étendue de ses marques, dont le dessin doit tenir aussi. */
    private static Axe axe(String nom, Range montre) {
        double min = montre.getLowerBound();
        double max = montre.getUpperBound();
        double jeu = Math.max(1 + 0.2 * Math.min(1, max / min - 1), Math.pow(max / min, 0.04));
        return new Axe(nom, min / jeu, max * jeu);
    }

    private XYIntervalSeriesCollection donnees(List<Serie> partie) {
        XYIntervalSeriesCollection donnees = new XYIntervalSeriesCollection();
        for (int s = 0; s < partie.size(); s++) {
            XYIntervalSeries points = new XYIntervalSeries(partie.get(s).nom, false, true);
            for (Marque m : partie.get(s).marques) {
                points.add(m.x.valeur, m.x.min, m.x.max, m.y.valeur, m.y.min, m.y.max);
            }
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
            setUseFillPaint(true);
            for (int s = 0; s < partie.size(); s++) {
                Serie serie = partie.get(s);
                boolean points = serie.forme != FormeDePoint.AUCUNE;
                setSeriesPaint(s, serie.couleur);
                setSeriesFillPaint(s, serie.couleur);
                setSeriesLinesVisible(s, Boolean.valueOf(serie.reliee));
                setSeriesShapesVisible(s, points);
                setSeriesShape(s, serie.forme.dessin);
                // un trait plus large reste visible derrière les autres
                setSeriesStroke(s, points ? Style.TRAIT : Style.TRAIT_FRONT);
                setSeriesOutlineStroke(s, Style.TRAIT);
                setDrawXError(points);
                setDrawYError(points);
                setSeriesVisibleInLegend(s, !serie.nom.isEmpty());
            }
        }

        @Override
        public Paint getItemFillPaint(int s, int point) {
            return partie.get(s).marques.get(point).pleine ? partie.get(s).couleur : Color.WHITE;
        }
    }

    /** Entoure les réglages par défaut, et écrit les noms des points, les plus importants d'abord. */
    private void annoter(Graphics2D g, Rectangle2D cadre) {
        Etiquettes noms = new Etiquettes(g, cadre);
        for (Serie serie : Stream.concat(fonds.stream(), series.stream()).toArray(Serie[]::new)) {
            double[] avant = null;
            for (Marque m : serie.marques) {
                double[] ici = {px(m.x.valeur, cadre), py(m.y.valeur, cadre)};
                noms.reserver(ici[0], ici[1], FormeDePoint.DEMI_COTE);
                if (m.cerclee) {
                    g.translate(ici[0], ici[1]);
                    g.setColor(Style.NOIR);
                    g.setStroke(Style.TRAIT);
                    g.draw(FormeDePoint.ANNEAU);
                    g.translate(-ici[0], -ici[1]);
                }
                if (serie.reliee && avant != null) {
                    noms.reserver(avant[0], avant[1], ici[0], ici[1]);
                }
                noms.reserver(px(m.x.min, cadre), ici[1], px(m.x.max, cadre), ici[1]);
                noms.reserver(ici[0], py(m.y.min, cadre), ici[0], py(m.y.max, cadre));
                avant = ici;
            }
        }
        if (mieux) {
            fleche(g, noms, cadre.getMinX() + 30, cadre.getMaxY() - 30);
        }
        niveaux.forEach((niveau, nom) -> {
            double y = py(niveau, cadre);
            noms.reserver(cadre.getMinX(), y, cadre.getMaxX(), y);
            // à droite s'il y a de la place, sinon de plus en plus à gauche
            DoubleStream.iterate(cadre.getMaxX(), x -> x - 20).limit((long) cadre.getWidth() / 20).anyMatch(
                    x -> noms.ecrire(nom, x, y - 18, -12, Style.ETIQUETTE, Style.GRIS, false));
        });
        for (int s = 0; s < series.size(); s++) {
            Marque bout = series.get(s).marques.get(series.get(s).marques.size() - 1);
            if (!series.get(s).bout.isEmpty()) {
                noms.ecrire(series.get(s).bout, px(bout.x.valeur, cadre), py(bout.y.valeur, cadre), 0, Style.ETIQUETTE_DEFAUT,
                        series.get(s).couleur.darker(), true);
            }
        }
        for (int tour = 0; tour < 3; tour++) {
            for (int s = 0; s < series.size(); s++) {
                for (Marque m : series.get(s).marques) {
                    if (tour == (m.cerclee ? 0 : m.pleine ? 1 : 2) && !m.etiquette.isEmpty()) {
                        noms.ecrire(m.etiquette, px(m.x.valeur, cadre), py(m.y.valeur, cadre), m.cerclee ? 8 : 0,
                                m.cerclee ? Style.ETIQUETTE_DEFAUT : Style.ETIQUETTE, series.get(s).couleur.darker(), true);
                    }
                }
            }
        }
    }

    private static void fleche(Graphics2D g, Etiquettes noms, double x, double y) {
        g.setColor(Style.ENCRE);
        g.setStroke(Style.TRAIT);
        g.draw(new Line2D.Double(x, y, x + 60, y - 60));
        g.draw(new Line2D.Double(x, y, x + 24, y));
        g.draw(new Line2D.Double(x, y, x, y - 24));
        noms.reserver(x, y, x + 60, y - 60);
        noms.ecrire("mieux", x + 60, y - 60, 0, Style.ETIQUETTE_DEFAUT, Style.ENCRE, false);
    }

    private double px(double x, Rectangle2D cadre) {
        return axeX.valueToJava2D(x, cadre, RectangleEdge.BOTTOM);
    }

    private double py(double y, Rectangle2D cadre) {
        return axeY.valueToJava2D(y, cadre, RectangleEdge.LEFT);
    }
}
