package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;

import lancer.Point;
import org.junit.jupiter.api.Test;

/** Le juge des intersections. */
class ExactTest {

    private static final Point ORIGINE = new Point();

    @Test
    void leJugeEstUnCalculSansArrondiQueLesFormesClosesConfirment() {
        // de face, de dedans, de dos, une tangente exacte, un départ sur la surface qui sort, puis qui entre
        juge(4, 1, new Exact(ORIGINE, new Point(0, 0, 1), new Point(0, 0, 5), 1));
        juge(2, 2, new Exact(ORIGINE, new Point(0, 0, 3), ORIGINE, 2));
        assertEquals(Double.POSITIVE_INFINITY, new Exact(ORIGINE, new Point(0, 0, -1), new Point(0, 0, 5), 1).distance);
        juge(5, 0, new Exact(ORIGINE, new Point(0, 0, 7), new Point(3, 0, 5), 3));
        assertEquals(Double.POSITIVE_INFINITY, new Exact(new Point(0, 0, 1), new Point(0, 0, 2), ORIGINE, 1).distance);
        juge(2, 1, new Exact(new Point(0, 0, 1), ORIGINE, ORIGINE, 1));
        // h² = 0,75, et le triangle 3, 4, 5 : les deux réponses ont une racine
        juge(2 - Math.sqrt(0.75), Math.sqrt(0.75), new Exact(new Point(0, 0.5, -2), new Point(0, 0.5, 0), ORIGINE, 1));
        juge(25 - Math.sqrt(7), Math.sqrt(7), new Exact(ORIGINE, new Point(3, 4, 0), new Point(15 - 2.4, 20 + 1.8, 0), 4), 4e-15);
        // au-dessus d'un sol de 2^60, à hauteur 2^-20 : c/(b + h) à l'aplomb est cette hauteur, que les doubles perdent
        juge(0x1p-20, 0x1p60, new Exact(new Point(0, 0x1p-20, 0), new Point(0, -1, 0), new Point(0, -0x1p60, 0), 0x1p60));
        assertEquals(-2, new Exact(ORIGINE, new Point(0, 0, 1), new Point(3, 0, 5), 1).enfoncement);
    }

    private static void juge(double distance, double demiCorde, Exact exact) {
        juge(distance, demiCorde, exact, 1e-15);
    }

    private static void juge(double distance, double demiCorde, Exact exact, double relative) {
        assertEquals(distance, exact.distance, relative * distance);
        assertEquals(demiCorde, exact.demiCorde, relative * demiCorde);
    }
}
