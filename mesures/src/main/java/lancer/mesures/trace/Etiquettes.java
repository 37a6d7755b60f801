package lancer.mesures.trace;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Écrit des noms à côté de points, aux endroits libres ; un nom qui n'a pas de place n'est pas écrit. */
final class Etiquettes {

    /** Directions essayées, par ordre de préférence, puis distances. */
    private static final double[][] DIRECTIONS = {{1, 0}, {1, -1}, {-1, 0}, {1, 1}, {0, -1}, {-1, -1}, {0, 1}, {-1, 1}};
    private static final double[] DISTANCES = {16, 24, 40, 60, 84, 120, 160};

    /** Distance au-delà de laquelle un trait relie le nom au point. */
    private static final double FIL = 30;

    private final Graphics2D g;
    private final Rectangle2D cadre;
    private final List<Rectangle2D> pris = new ArrayList<>();
    private final List<Rectangle2D> ecrits = new ArrayList<>();

    Etiquettes(Graphics2D g, Rectangle2D cadre) {
        this.g = g;
        this.cadre = cadre;
    }

    /** Réserve ce carré. */
    void reserver(double x, double y, double demiCote) {
        pris.add(new Rectangle2D.Double(x - demiCote, y - demiCote, 2 * demiCote, 2 * demiCote));
    }

    /** Réserve les environs de ce trait. */
    void reserver(double x0, double y0, double x1, double y1) {
        double longueur = Math.hypot(x1 - x0, y1 - y0);
        for (double t = 0; t < longueur; t += 6) {
            reserver(x0 + (x1 - x0) * t / longueur, y0 + (y1 - y0) * t / longueur, 3);
        }
    }

    /**
     * @param depart rayon de ce qui est dessiné autour du point
     * @param loin vrai si le nom peut être écrit plus loin, relié par un trait
     * @return faux s'il n'y a pas de place
     */
    boolean ecrire(String texte, double x, double y, double depart, Font police, Color couleur, boolean loin) {
        FontMetrics mesures = g.getFontMetrics(police);
        String[] lignes = texte.split("\n");
        double largeur = Arrays.stream(lignes).mapToInt(mesures::stringWidth).max().orElse(0);
        double hauteur = mesures.getAscent() + (lignes.length - 1) * mesures.getHeight();
        for (double distance : Arrays.copyOf(DISTANCES, loin ? DISTANCES.length : 1)) {
            for (double[] d : DIRECTIONS) {
                double norme = Math.hypot(d[0], d[1]);
                double cx = x + d[0] / norme * (distance + depart) + d[0] * largeur / 2;
                double cy = y + d[1] / norme * (distance + depart) + d[1] * hauteur / 2;
                Rectangle2D place = new Rectangle2D.Double(cx - largeur / 2 - 2, cy - hauteur / 2, largeur + 4, hauteur);
                Line2D fil = new Line2D.Double(x, y, Math.max(place.getMinX(), Math.min(place.getMaxX(), x)),
                        Math.max(place.getMinY(), Math.min(place.getMaxY(), y)));
                if (cadre.contains(place) && pris.stream().noneMatch(p -> p.intersects(place))
                        && ecrits.stream().noneMatch(e -> e.intersectsLine(fil))) {
                    pris.add(place);
                    ecrits.add(place);
                    g.setFont(police);
                    g.setColor(couleur);
                    if (distance > FIL) {
                        g.setStroke(Style.TRAIT_FIN);
                        g.draw(fil);
                    }
                    for (int k = 0; k < lignes.length; k++) {
                        g.drawString(lignes[k], (float) (cx - largeur / 2),
                                (float) (cy - hauteur / 2 + mesures.getAscent() - mesures.getDescent() / 2.0 + k * mesures.getHeight()));
                    }
                    return true;
                }
            }
        }
        return false;
    }
}
