package lancer.mesures.trace;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jfree.chart.ui.RectangleEdge;

/** Des choses nommées à gauche, une par rangée, et pour chacune combien, sur un axe logarithmique : une partie d'une planche. */
public final class Rangees implements Contenu {

    private final String constat;
    private final String nomX;
    private final List<String> noms;
    private final List<Serie> series = new ArrayList<>();
    private final double repere;

    /**
     * @param noms des rangées, de haut en bas ; une marque d'ordonnée k est dans la k-ième, comptée de 0
     * @param repere où tracer une droite verticale
     */
    public Rangees(String constat, String nomX, List<String> noms, double repere) {
        this.constat = constat;
        this.nomX = nomX;
        this.noms = new ArrayList<>(noms);
        this.repere = repere;
    }

    public Rangees serie(Serie serie) {
        series.add(serie);
        return this;
    }

    @Override
    public List<Serie> series() {
        return Collections.unmodifiableList(series);
    }

    @Override
    public double enTete(Graphics2D g, double largeur) {
        return phrase(g, largeur).hauteur() + 20;
    }

    private Paragraphe phrase(Graphics2D g, double largeur) {
        return new Paragraphe(g, constat, Style.CONSTAT, largeur - 16);
    }

    @Override
    public void dessiner(Graphics2D g, Rectangle2D place, double enTete) {
        phrase(g, place.getWidth()).dessiner(g, place.getX() + 8, place.getY(), Style.ENCRE);
        double haut = place.getY() + enTete;
        double gauche = noms.stream().mapToDouble(n -> g.getFontMetrics(Style.AXE).stringWidth(n)).max().orElse(0) + 24;
        Rectangle2D cadre = new Rectangle2D.Double(place.getX() + gauche, haut, place.getWidth() - gauche - 12,
                place.getMaxY() - haut - 84);
        Axe axe = axe();
        g.setStroke(Style.TRAIT_FIN);
        for (int k = 0; k < noms.size(); k++) {
            double y = rangee(k, cadre);
            g.setColor(Style.GRILLE);
            g.draw(new Line2D.Double(cadre.getMinX(), y, cadre.getMaxX(), y));
            g.setColor(Style.ENCRE);
            g.setFont(Style.AXE);
            double largeur = g.getFontMetrics().stringWidth(noms.get(k));
            g.drawString(noms.get(k), (float) (cadre.getMinX() - 12 - largeur), (float) (y + g.getFontMetrics().getAscent() / 2.0 - 3));
        }
        double x = axe.valueToJava2D(repere, cadre, RectangleEdge.BOTTOM);
        g.setColor(Style.GRIS);
        g.setStroke(Style.POINTILLE);
        g.draw(new Line2D.Double(x, cadre.getMinY(), x, cadre.getMaxY()));
        axe.draw(g, cadre.getMaxY(), place, cadre, RectangleEdge.BOTTOM, null);
        g.setStroke(Style.TRAIT_FIN);
        g.setColor(Style.GRIS);
        g.draw(cadre);
        marques(g, axe, cadre);
    }

    private Axe axe() {
        double min = repere;
        double max = repere;
        for (Serie serie : series) {
            for (Marque m : serie.marques) {
                min = Math.min(min, m.xMin);
                max = Math.max(max, m.xMax);
            }
        }
        double jeu = 1 + 0.06 * Math.min(5, max / min);
        return new Axe(nomX, min / jeu, max * jeu, 0);
    }

    private double rangee(double k, Rectangle2D cadre) {
        return cadre.getMinY() + (k + 0.5) / noms.size() * cadre.getHeight();
    }

    private void marques(Graphics2D g, Axe axe, Rectangle2D cadre) {
        double ecart = Math.min(26, cadre.getHeight() / noms.size() / (series.size() + 1));
        for (int s = 0; s < series.size(); s++) {
            Serie serie = series.get(s);
            for (Marque m : serie.marques) {
                double y = rangee(m.y, cadre) + (s - (series.size() - 1) / 2.0) * ecart;
                double x = axe.valueToJava2D(m.x, cadre, RectangleEdge.BOTTOM);
                g.setColor(serie.couleur);
                g.setStroke(Style.TRAIT_FIN);
                if (m.xMin < m.xMax) {
                    double gauche = axe.valueToJava2D(m.xMin, cadre, RectangleEdge.BOTTOM);
                    double droite = axe.valueToJava2D(m.xMax, cadre, RectangleEdge.BOTTOM);
                    g.draw(new Line2D.Double(gauche, y, droite, y));
                    g.draw(new Line2D.Double(gauche, y - 6, gauche, y + 6));
                    g.draw(new Line2D.Double(droite, y - 6, droite, y + 6));
                }
                g.translate(x, y);
                g.fill(serie.forme.dessin);
                g.translate(-x, -y);
                if (!m.etiquette.isEmpty()) {
                    etiquette(g, m.etiquette, axe.valueToJava2D(m.xMax, cadre, RectangleEdge.BOTTOM), x, y, cadre);
                }
            }
        }
    }

    /** À droite de la marque, ou à gauche s'il n'y a pas la place. */
    private static void etiquette(Graphics2D g, String texte, double droite, double x, double y, Rectangle2D cadre) {
        g.setFont(Style.ETIQUETTE);
        double largeur = g.getFontMetrics().stringWidth(texte);
        double debut = Math.max(droite, x) + 18;
        double place = debut + largeur < cadre.getMaxX() ? debut : x - 18 - largeur;
        double hauteur = g.getFontMetrics().getAscent();
        g.setColor(Color.WHITE);
        g.fill(new Rectangle2D.Double(place - 3, y - hauteur / 2, largeur + 6, hauteur));
        g.setColor(Style.ENCRE);
        g.drawString(texte, (float) place, (float) (y + g.getFontMetrics().getAscent() / 2.0 - 3));
    }
}
