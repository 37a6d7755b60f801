package lancer.mesures.trace;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** Une partie d'une {@link Planche} : une courbe, une image… */
public interface Contenu {

    /** La hauteur de ce qui s'écrit au-dessus, dans cette largeur. */
    double enTete(Graphics2D g, double largeur);

    /**
     * Dessine tout entier dans ce rectangle.
     *
     * @param enTete hauteur à laisser au-dessus, la même pour tous les volets d'une planche
     */
    void dessiner(Graphics2D g, Rectangle2D place, double enTete);

    /** Les séries à nommer dans la légende. */
    List<Serie> series();

    /** Vrai si un front y est tracé. */
    default boolean aUnFront() {
        return false;
    }

    /** Vrai si une marque y est cerclée. */
    default boolean aDesDefauts() {
        return false;
    }
}
