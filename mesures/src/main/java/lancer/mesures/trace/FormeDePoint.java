package lancer.mesures.trace;

import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import org.jfree.chart.util.ShapeUtils;

/** La forme d'un point, qui distingue deux séries sans la couleur. Les formes pleines ont à peu près la même aire. */
public enum FormeDePoint {

    ROND(new Ellipse2D.Double(-9, -9, 18, 18)),
    CARRE(new Rectangle2D.Double(-8, -8, 16, 16)),
    TRIANGLE(ShapeUtils.createUpTriangle(10)),
    POINTE(ShapeUtils.createDownTriangle(10)),
    LOSANGE(ShapeUtils.createDiamond(12)),
    CROIX(ShapeUtils.createRegularCross(9, 3.5f)),

    /** Un cercle vide, autour d'un point d'une autre série. */
    ANNEAU(new Ellipse2D.Double(-20, -20, 40, 40)),

    /** Aucun point : le trait seul. */
    AUCUNE(new Rectangle2D.Double());

    final Shape dessin;

    FormeDePoint(Shape dessin) {
        this.dessin = dessin;
    }
}
