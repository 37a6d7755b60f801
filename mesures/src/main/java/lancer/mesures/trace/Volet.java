package lancer.mesures.trace;

import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.DatasetRenderingOrder;
import org.jfree.chart.plot.IntervalMarker;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

/** Deux axes logarithmiques et des séries : une courbe d'une {@link Planche}, sous la phrase qui dit ce qu'on y voit. */
public final class Volet implements Contenu {

    private static final double JEU = 1.35;
    private static final double RETRAIT = 8;

    /** Rapport des bornes au-delà duquel le jeu est une part de l'axe : une marque au bord doit y tenir. */
    private static final double IMMENSE = 5e6;
    private static final double PART_DU_JEU = 0.04;

    private final String constat;
    private final String sujet;
    private final String nomX;
    private final String nomY;
    private final List<Serie> series = new ArrayList<>();
    private final List<Marque> front = new ArrayList<>();
    private final List<Repere> reperes = new ArrayList<>();
    private double minX = Double.POSITIVE_INFINITY;
    private double maxX;
    private double minY = Double.POSITIVE_INFINITY;
    private double maxY;
    private double plancherY;
    private boolean versZero;
    private Axe axeX;
    private Axe axeY;

    /** Une droite horizontale qui aide à lire. */
    private static final class Repere {
        private final double y;
        private final String nom;

        Repere(double y, String nom) {
            this.y = y;
            this.nom = nom;
        }
    }

    /**
     * @param constat ce que montre la courbe, en une phrase
     * @param sujet de quoi elle parle, vide si le titre de la planche le dit
     * @param nomX et son unité
     * @param nomY et son unité
     */
    public Volet(String constat, String sujet, String nomX, String nomY) {
        this.constat = constat;
        this.sujet = sujet;
        this.nomX = nomX;
        this.nomY = nomY;
    }

    /** @param plancher ce qui est plus petit est dessiné dans une bande à part, celle de zéro ; 0 : pas de bande */
    public Volet plancher(double plancher) {
        plancherY = plancher;
        return this;
    }

    /** Les abscisses décroissent vers la droite : ce qui est difficile est à droite de ce qui est facile. */
    public Volet versZero() {
        versZero = true;
        return this;
    }

    public Volet serie(Serie serie) {
        series.add(serie);
        return this;
    }

    /** La ligne des marques que rien ne bat, derrière tout le reste. */
    public Volet front(List<Marque> marques) {
        front.addAll(marques);
        return this;
    }

    /** Une droite horizontale en pointillé, et ce qu'elle veut dire. */
    public Volet repere(double y, String nom) {
        reperes.add(new Repere(y, nom));
        return this;
    }

    @Override
    public List<Serie> series() {
        return Collections.unmodifiableList(series);
    }

    @Override
    public boolean aUnFront() {
        return !front.isEmpty();
    }

    @Override
    public boolean aDesDefauts() {
        return series.stream().anyMatch(s -> s.marques.stream().anyMatch(m -> m.cerclee));
    }

    @Override
    public double enTete(Graphics2D g, double largeur) {
        return phrase(g, largeur).hauteur() + (sujet.isEmpty() ? 0 : g.getFontMetrics(Style.SOUS_TITRE).getHeight()) + 16;
    }

    private Paragraphe phrase(Graphics2D g, double largeur) {
        return new Paragraphe(g, constat, Style.CONSTAT, largeur - 2 * RETRAIT);
    }

    @Override
    public void dessiner(Graphics2D g, Rectangle2D place, double enTete) {
        double x = place.getX() + RETRAIT;
        Paragraphe phrase = phrase(g, place.getWidth());
        phrase.dessiner(g, x, place.getY(), Style.ENCRE);
        double bas = place.getY() + enTete;
        if (!sujet.isEmpty()) {
            new Paragraphe(g, sujet, Style.SOUS_TITRE, place.getWidth())
                    .dessiner(g, x, place.getY() + phrase.hauteur() + 2, Style.GRIS);
        }
        Rectangle2D reste = new Rectangle2D.Double(place.getX(), bas, place.getWidth(), place.getMaxY() - bas);
        axes();
        JFreeChart courbe = new JFreeChart(null, null, plot(), false);
        courbe.setBackgroundPaint(null);
        courbe.setPadding(new RectangleInsets(0, 0, 0, 12));
        ChartRenderingInfo info = new ChartRenderingInfo();
        courbe.draw(g, reste, info);
        etiqueter(g, info.getPlotInfo().getDataArea());
    }

    private void axes() {
        for (Serie serie : series) {
            for (Marque m : serie.marques) {
                minX = Math.min(minX, m.xMin);
                maxX = Math.max(maxX, m.xMax);
                maxY = Math.max(maxY, m.yMax);
                minY = m.y > plancherY ? Math.min(minY, m.yMin) : minY;
            }
        }
        boolean zero = series.stream().anyMatch(s -> s.marques.stream().anyMatch(m -> m.y <= plancherY));
        double jeuX = Math.min(JEU, 1 + 0.2 * (maxX / minX - 1));
        jeuX = maxX / minX > IMMENSE ? Math.pow(maxX / minX, PART_DU_JEU) : jeuX;
        axeX = new Axe(nomX, minX / jeuX, maxX * Math.max(1.05, jeuX), 0);
        axeX.setInverted(versZero);
        minY = minY > maxY ? maxY / 10 : minY;
        double jeuY = maxY / minY > IMMENSE ? Math.pow(maxY / minY, PART_DU_JEU) : JEU;
        double bas = zero && plancherY > 0 ? plancherY : minY / jeuY;
        double haut = maxY * jeuY;
        axeY = new Axe(nomY, bas, haut, zero && plancherY > 0 ? bas / Math.pow(haut / bas, 0.05) : 0);
    }

    private XYPlot plot() {
        XYPlot plot = new XYPlot(null, axeX, axeY, null);
        plot.setBackgroundPaint(null);
        plot.setOutlinePaint(Style.GRIS);
        plot.setDomainGridlinePaint(Style.GRILLE);
        plot.setRangeGridlinePaint(Style.GRILLE);
        plot.setDomainGridlineStroke(Style.TRAIT_FIN);
        plot.setRangeGridlineStroke(Style.TRAIT_FIN);
        plot.setDatasetRenderingOrder(DatasetRenderingOrder.FORWARD);
        if (axeY.seuilDeZero() > 0) {
            plot.addRangeMarker(new IntervalMarker(axeY.getLowerBound(), axeY.seuilDeZero(), Style.BANDE), Layer.BACKGROUND);
        }
        for (Repere repere : reperes) {
            plot.addRangeMarker(new ValueMarker(repere.y, Style.GRIS, Style.POINTILLE), Layer.BACKGROUND);
        }
        ajouter(plot, lignes(front), ligne(Style.FRONT));
        for (Serie serie : series) {
            if (serie.reliee) {
                XYLineAndShapeRenderer trait = new XYLineAndShapeRenderer(true, false);
                trait.setSeriesPaint(0, serie.couleur);
                trait.setSeriesStroke(0, Style.TRAIT);
                ajouter(plot, lignes(serie.marques), trait);
            }
        }
        for (Serie serie : series) {
            XYIntervalSeries points = new XYIntervalSeries(serie.nom, false, true);
            for (Marque m : serie.marques) {
                points.add(m.x, m.xMin, m.xMax, axeY.place(m.y), axeY.place(m.yMin), axeY.place(m.yMax));
            }
            XYIntervalSeriesCollection donnees = new XYIntervalSeriesCollection();
            donnees.addSeries(points);
            ajouter(plot, donnees, new Points(serie));
        }
        return plot;
    }

    private static XYLineAndShapeRenderer ligne(Paint couleur) {
        XYLineAndShapeRenderer ligne = new XYLineAndShapeRenderer(true, false);
        ligne.setSeriesPaint(0, couleur);
        ligne.setSeriesStroke(0, Style.TRAIT_FRONT);
        return ligne;
    }

    private XYSeriesCollection lignes(List<Marque> marques) {
        XYSeries ligne = new XYSeries("", false, true);
        for (Marque m : marques) {
            ligne.add(m.x, axeY.place(m.y));
        }
        return new XYSeriesCollection(ligne);
    }

    private static void ajouter(XYPlot plot, org.jfree.data.xy.XYDataset donnees, XYLineAndShapeRenderer rendu) {
        int rang = plot.getDatasetCount();
        // le premier rang existe déjà, vide
        int libre = plot.getDataset(0) == null ? 0 : rang;
        plot.setDataset(libre, donnees);
        plot.setRenderer(libre, rendu);
    }

    /** Les points d'une série et leurs barres ; en creux ceux qui ne valent pas la peine. */
    private static final class Points extends XYErrorRenderer {

        private static final long serialVersionUID = 1;

        private final transient Serie serie;

        Points(Serie serie) {
            this.serie = serie;
            setDrawYError(serie.marques.stream().anyMatch(m -> m.yMin < m.yMax));
            setDrawXError(serie.marques.stream().anyMatch(m -> m.xMin < m.xMax));
            setErrorStroke(Style.TRAIT_FIN);
            setErrorPaint(serie.couleur);
            setCapLength(10);
            setSeriesPaint(0, serie.couleur);
            setSeriesShape(0, serie.forme.dessin);
            setSeriesOutlineStroke(0, Style.TRAIT);
            setUseFillPaint(true);
            setDrawOutlines(true);
        }

        @Override
        public Paint getItemFillPaint(int rang, int point) {
            return serie.marques.get(point).pleine ? serie.couleur : java.awt.Color.WHITE;
        }
    }

    /** Cercle les réglages par défaut, et nomme les points : les plus importants d'abord, les autres s'il y a de la place tout près. */
    private void etiqueter(Graphics2D g, Rectangle2D cadre) {
        ToDoubleFunction<Marque> enX = m -> pixel(axeX, m.x, cadre, RectangleEdge.BOTTOM);
        ToDoubleFunction<Marque> enY = m -> pixel(axeY, axeY.place(m.y), cadre, RectangleEdge.LEFT);
        Etiquettes noms = new Etiquettes(g, cadre);
        for (Serie serie : series) {
            Marque avant = null;
            for (Marque m : serie.marques) {
                noms.reserver(enX.applyAsDouble(m), enY.applyAsDouble(m), FormeDePoint.DEMI_COTE);
                if (m.cerclee) {
                    cercler(g, enX.applyAsDouble(m), enY.applyAsDouble(m));
                }
                if (serie.reliee && avant != null) {
                    noms.reserver(enX.applyAsDouble(avant), enY.applyAsDouble(avant), enX.applyAsDouble(m), enY.applyAsDouble(m));
                }
                if (m.xMin < m.xMax) {
                    noms.reserver(pixel(axeX, m.xMin, cadre, RectangleEdge.BOTTOM), enY.applyAsDouble(m),
                            pixel(axeX, m.xMax, cadre, RectangleEdge.BOTTOM), enY.applyAsDouble(m));
                }
                if (m.yMin < m.yMax) {
                    noms.reserver(enX.applyAsDouble(m), pixel(axeY, axeY.place(m.yMin), cadre, RectangleEdge.LEFT),
                            enX.applyAsDouble(m), pixel(axeY, axeY.place(m.yMax), cadre, RectangleEdge.LEFT));
                }
                avant = m;
            }
        }
        for (int tour = 0; tour < 3; tour++) {
            for (Serie serie : series) {
                for (Marque m : serie.marques) {
                    int rang = m.cerclee ? 0 : m.pleine ? 1 : 2;
                    if (rang == tour && !m.etiquette.isEmpty()) {
                        noms.ecrire(m.etiquette, enX.applyAsDouble(m), enY.applyAsDouble(m), m.cerclee ? 8 : 0,
                                m.cerclee ? Style.ETIQUETTE_DEFAUT : Style.ETIQUETTE, Style.ENCRE, m.pleine || m.cerclee || serie.reliee);
                    }
                }
            }
        }
        for (Repere repere : reperes) {
            double y = pixel(axeY, repere.y, cadre, RectangleEdge.LEFT);
            double largeur = g.getFontMetrics(Style.ETIQUETTE).stringWidth(repere.nom);
            noms.ecrire(repere.nom, cadre.getMaxX() - largeur / 2 - 12, y - 18, -12, Style.ETIQUETTE, Style.GRIS, false);
        }
    }

    private static double pixel(ValueAxis axe, double valeur, Rectangle2D cadre, RectangleEdge bord) {
        return axe.valueToJava2D(valeur, cadre, bord);
    }

    private static void cercler(Graphics2D g, double x, double y) {
        g.translate(x, y);
        g.setColor(Style.NOIR);
        g.setStroke(Style.TRAIT);
        g.draw(FormeDePoint.ANNEAU);
        g.translate(-x, -y);
    }
}
