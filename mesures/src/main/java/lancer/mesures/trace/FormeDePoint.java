package lancer.mesures.trace;

import java.awt.Shape;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/** La forme d'un point : deux séries se distinguent aussi sans la couleur. Toutes ont à peu près la même aire. */
public enum FormeDePoint {

    ROND(new Ellipse2D.Double(-9, -9, 18, 18)),
    CARRE(new Rectangle2D.Double(-8, -8, 16, 16)),
    TRIANGLE(polygone(0, -11, 10.5, 8, -10.5, 8)),
    POINTE(polygone(0, 11, 10.5, -8, -10.5, -8)),
    LOSANGE(polygone(0, -12, 12, 0, 0, 12, -12, 0)),
    ETOILE(etoile()),
    CROIX(croix()),

    /** Rien : il ne reste que le trait. */
    AUCUNE(new Rectangle2D.Double());

    /** Autour d'un réglage par défaut. */
    static final Shape ANNEAU = new Ellipse2D.Double(-20, -20, 40, 40);

    /** Demi-côté de la place que prend un point, en pixels. */
    static final double DEMI_COTE = 12;

    final Shape dessin;

    FormeDePoint(Shape dessin) {
        this.dessin = dessin;
    }

    private static Shape polygone(double... coordonnees) {
        Path2D chemin = new Path2D.Double();
        chemin.moveTo(coordonnees[0], coordonnees[1]);
        for (int k = 2; k < coordonnees.length; k += 2) {
            chemin.lineTo(coordonnees[k], coordonnees[k + 1]);
        }
        chemin.closePath();
        return chemin;
    }

    private static Shape etoile() {
        double[] sommets = new double[20];
        for (int k = 0; k < 10; k++) {
            double rayon = k % 2 == 0 ? 14 : 6;
            sommets[2 * k] = rayon * Math.sin(Math.PI * k / 5);
            sommets[2 * k + 1] = -rayon * Math.cos(Math.PI * k / 5);
        }
        return polygone(sommets);
    }

    private static Shape croix() {
        Area croix = new Area(new Rectangle2D.Double(-11, -4, 22, 8));
        croix.add(new Area(new Rectangle2D.Double(-4, -11, 8, 22)));
        return croix;
    }
}
