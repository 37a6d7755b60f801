package lancer.mesures.trace;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import org.jfree.chart.LegendItemCollection;

/** Une partie d'une {@link Planche} : une courbe, des images… */
public interface Contenu {

    /** La hauteur de ce qui s'écrit au-dessus, dans cette largeur. */
    default double enTete(Graphics2D g, double largeur) {
        return 0;
    }

    /**
     * Dessine tout entier dans ce rectangle.
     *
     * @param enTete hauteur à laisser au-dessus, la même pour tous les volets d'une rangée
     */
    void dessiner(Graphics2D g, Rectangle2D place, double enTete);

    /** Ce qui se nomme dans la légende, une fois pour toute la planche. */
    default LegendItemCollection legende() {
        return new LegendItemCollection();
    }
}
