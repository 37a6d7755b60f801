package lancer.mesures.trace;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import org.jfree.chart.ui.RectangleEdge;

/** Des choses nommées à gauche, une par rangée, une barre pour combien, et un point, presque toujours à zéro, pour le témoin. */
public final class Barres implements Contenu {

    private static final double BAS = 92;

    private final String constat;
    private final List<String> noms;
    private final Serie barres;
    private final Serie temoins;
    private final Axe axe;

    /**
     * @param noms des rangées, de haut en bas
     * @param barres une marque par rangée, la longueur en abscisse
     * @param temoins une marque par rangée
     * @param max ce que l'axe montre au plus
     */
    public Barres(String constat, String nomX, List<String> noms, Serie barres, Serie temoins, double max) {
        this.constat = constat;
        this.noms = noms;
        this.barres = barres;
        this.temoins = temoins;
        axe = new Axe(nomX, 0.6, max * 3, 0.25);
    }

    @Override
    public List<Serie> series() {
        return Arrays.asList(temoins, barres);
    }

    @Override
    public double enTete(Graphics2D g, double largeur) {
        return phrase(g, largeur).hauteur() + 14;
    }

    private Paragraphe phrase(Graphics2D g, double largeur) {
        return new Paragraphe(g, constat, Style.CONSTAT, largeur - 16);
    }

    @Override
    public void dessiner(Graphics2D g, Rectangle2D place, double enTete) {
        phrase(g, place.getWidth()).dessiner(g, place.getX() + 8, place.getY(), Style.ENCRE);
        double gauche = noms.stream().mapToDouble(n -> g.getFontMetrics(Style.AXE).stringWidth(n)).max().orElse(0) + 28;
        double haut = place.getY() + enTete;
        Rectangle2D cadre = new Rectangle2D.Double(place.getX() + gauche, haut, place.getWidth() - gauche - 16,
                place.getMaxY() - haut - BAS);
        double zero = axe.valueToJava2D(axe.place(0), cadre, RectangleEdge.BOTTOM);
        double un = axe.valueToJava2D(axe.seuilDeZero(), cadre, RectangleEdge.BOTTOM);
        g.setColor(Style.BANDE);
        g.fill(new Rectangle2D.Double(cadre.getMinX(), cadre.getMinY(), un - cadre.getMinX(), cadre.getHeight()));
        double pas = cadre.getHeight() / noms.size();
        for (int k = 0; k < noms.size(); k++) {
            double y = cadre.getMinY() + (k + 0.5) * pas;
            g.setFont(Style.AXE);
            g.setColor(Style.ENCRE);
            g.drawString(noms.get(k), (float) (cadre.getMinX() - 14 - g.getFontMetrics().stringWidth(noms.get(k))),
                    (float) (y + g.getFontMetrics().getAscent() / 2.0 - 3));
            Marque barre = barres.marques.get(k);
            double bout = axe.valueToJava2D(axe.place(barre.x), cadre, RectangleEdge.BOTTOM);
            g.setColor(barres.couleur);
            g.fill(new Rectangle2D.Double(zero, y - 0.3 * pas, bout - zero, 0.6 * pas));
            g.setFont(Style.ETIQUETTE);
            g.setColor(Style.ENCRE);
            g.drawString(barre.etiquette, (float) (bout + 12), (float) (y + g.getFontMetrics().getAscent() / 2.0 - 3));
            double temoin = axe.valueToJava2D(axe.place(temoins.marques.get(k).x), cadre, RectangleEdge.BOTTOM);
            g.translate(temoin, y);
            g.setColor(temoins.couleur);
            g.fill(temoins.forme.dessin);
            g.translate(-temoin, -y);
        }
        axe.draw(g, cadre.getMaxY(), place, cadre, RectangleEdge.BOTTOM, null);
        g.setStroke(Style.TRAIT_FIN);
        g.setColor(Style.GRIS);
        g.draw(new Line2D.Double(un, cadre.getMinY(), un, cadre.getMaxY()));
        g.draw(cadre);
    }
}
