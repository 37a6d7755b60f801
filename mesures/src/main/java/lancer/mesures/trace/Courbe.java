package lancer.mesures.trace;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.Axis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.DatasetRenderingOrder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleInsets;

/** Deux axes et ce qu'on y trace, sous la phrase qui dit ce qu'on y voit. */
abstract class Courbe implements Contenu {

    private static final double RETRAIT = 8;

    private final String constat;
    private final String sujet;

    /**
     * @param constat ce que l'on voit, en une phrase
     * @param sujet de quoi il s'agit, vide si le titre de la planche le dit
     */
    Courbe(String constat, String sujet) {
        this.constat = constat;
        this.sujet = sujet;
    }

    abstract XYPlot plot();

    /** Ce qui s'ajoute par-dessus, une fois le cadre connu. */
    void annoter(Graphics2D g, Rectangle2D cadre) {
    }

    @Override
    public double enTete(Graphics2D g, double largeur) {
        return ecrire(g, 0, 0, largeur, false) + 14;
    }

    private double ecrire(Graphics2D g, double x, double y, double largeur, boolean vraiment) {
        double haut = Style.texte(g, constat, Style.CONSTAT, Style.ENCRE, x, y, largeur - 2 * RETRAIT, vraiment);
        return haut + Style.texte(g, sujet, Style.TEXTE, Style.GRIS, x, y + haut, largeur - 2 * RETRAIT, vraiment);
    }

    @Override
    public void dessiner(Graphics2D g, Rectangle2D place, double enTete) {
        ecrire(g, place.getX() + RETRAIT, place.getY(), place.getWidth(), true);
        XYPlot plot = plot();
        plot.setOutlinePaint(Style.GRIS);
        plot.setDomainGridlinePaint(Style.GRILLE);
        plot.setRangeGridlinePaint(Style.GRILLE);
        plot.setDomainGridlineStroke(Style.TRAIT_FIN);
        plot.setRangeGridlineStroke(Style.TRAIT_FIN);
        plot.setDatasetRenderingOrder(DatasetRenderingOrder.FORWARD);
        habiller(plot.getDomainAxis());
        habiller(plot.getRangeAxis());
        JFreeChart courbe = new JFreeChart(null, null, plot, false);
        courbe.setBackgroundPaint(null);
        courbe.setPadding(new RectangleInsets(10, 0, 0, 16));
        ChartRenderingInfo info = new ChartRenderingInfo();
        courbe.draw(g, new Rectangle2D.Double(place.getX(), place.getY() + enTete, place.getWidth(), place.getHeight() - enTete), info);
        annoter(g, info.getPlotInfo().getDataArea());
    }

    private static void habiller(Axis axe) {
        axe.setLabelFont(Style.TEXTE);
        axe.setLabelPaint(Style.ENCRE);
        axe.setTickLabelFont(Style.TEXTE);
        axe.setTickLabelPaint(Style.ENCRE);
        axe.setAxisLinePaint(Style.GRIS);
        axe.setTickMarkPaint(Style.GRIS);
        ((ValueAxis) axe).setMinorTickMarksVisible(false);
    }
}
