package lancer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.Set;
import java.util.function.Function;
import org.junit.jupiter.api.Test;

/** Ce que les classes du cours promettent et que les mutations ont montré que personne ne vérifiait. Voir docs/mutations.md. */
class ArithmetiqueTest {

    private static final double[] VALEURS = {0, 1, -1, 2, 0.5, 1e100, Double.NaN, Double.POSITIVE_INFINITY};

    /** Un code ne doit rien de plus qu'être égal pour des égaux ; mais s'il confond tout, une table n'est plus qu'une liste. */
    @Test
    void desTripletsVoisinsOntPresqueTousUnCodeALui() {
        for (Function<double[], Object> fait : fabriques()) {
            Set<Integer> codes = new HashSet<>();
            for (int k = 0; k < 1000; k++) {
                double[] t = {k / 100 / 10.0, k / 10 % 10 / 10.0, k % 10 / 10.0};
                codes.add(fait.apply(t).hashCode());
                assertEquals(fait.apply(t).hashCode(), fait.apply(t.clone()).hashCode());
            }
            assertTrue(codes.size() > 900, codes.size() + " codes pour 1000 triplets");
        }
    }

    @Test
    void deuxTripletsNeSontEgauxQueSiChaqueComposanteLEst() {
        for (Function<double[], Object> fait : fabriques()) {
            for (double x : VALEURS) {
                double[] t = {x, 3, 4};
                assertEquals(fait.apply(t), fait.apply(t.clone()));
                for (int k = 0; k < 3; k++) {
                    double[] autre = t.clone();
                    autre[k] = 7;
                    assertNotEquals(fait.apply(t), fait.apply(autre));
                }
            }
            assertNotEquals(fait.apply(new double[3]), fait.apply(new double[] {-0.0, 0, 0}));
            assertNotEquals(fait.apply(new double[3]), "0 0 0");
            assertNotEquals(fait.apply(new double[3]), null);
        }
        assertNotEquals(new Point(1, 2, 3), new Vecteur(1, 2, 3));
    }

    private static Iterable<Function<double[], Object>> fabriques() {
        return Arrays.asList(t -> new Vecteur(t[0], t[1], t[2]), t -> new Point(t[0], t[1], t[2]),
                t -> new Couleur(t[0], t[1], t[2]));
    }

    @Test
    void unObjetSEcritAvecSesValeurs() {
        assertEquals("Vecteur(1.0, 0.0, -2.5)", new Vecteur(1, 0, -2.5).toString());
        assertEquals("Couleur(0.9, 0.15, 0.1)", new Couleur(0.9, 0.15, 0.1).toString());
        assertEquals("Sphere(Point(0.0, 0.5, 6.0), 1.0)", new Sphere(new Point(0, 0.5, 6), 1).toString());
        assertEquals("Lampe(Point(-4.0, 6.0, -3.0), Couleur(1.0, 1.0, 1.0))", new Lampe(new Point(-4, 6, -3), new Couleur(1)).toString());
    }

    @Test
    void lePlusGrandEtLePlusPetitRayonSontPermis() {
        for (double rayon : new double[] {Double.MAX_VALUE, Double.MIN_VALUE}) {
            assertEquals(rayon, new Sphere(new Point(), rayon).getRayon());
        }
        for (double rayon : new double[] {0, -0.0, -1, Double.POSITIVE_INFINITY, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> new Sphere(new Point(), rayon));
        }
    }

    @Test
    void uneImageDUnPixelEstVueDansLAxe() {
        Rayon rayon = new Camera(1, 1).getRayon(0.5, 0.5);
        assertEquals(new Point(0, 0, 0), rayon.getP());
        assertEquals(new Vecteur(0, 0, 1), rayon.getV());
        for (int[] taille : new int[][] {{0, 1}, {1, 0}, {-1, 5}}) {
            assertThrows(IllegalArgumentException.class, () -> new Camera(taille[0], taille[1]));
        }
    }

    /** Une forme nouvelle n'a que deux méthodes à donner ; son contact est alors P + t V, tel quel. */
    @Test
    void uneFormeSansPointDeSurfaceGardeSonContact() {
        Objet3D plan = new Objet3D() {
            @Override
            public double getIntersectionDistance(Rayon incident) {
                double t = (7 - incident.getP().z) / incident.getV().z;
                incident.setContact(this, t);
                return t;
            }

            @Override
            public Vecteur getNormale(Point contact) {
                return new Vecteur(0, 0, -1);
            }
        };
        Rayon rayon = new Rayon(new Point(1, 2, 3), new Point(1, 5, 7));
        plan.getIntersectionDistance(rayon);
        PointContact contact = rayon.calcContact();
        assertSame(plan, contact.objet);
        assertEquals(rayon.getP().add(rayon.getV().mul(5)), new Point(contact.x, contact.y, contact.z));
    }

    @Test
    void leBrouillonLanceUnRayonParCarreDeQuatrePixelsMemeCoupeParLeBord() {
        Scene ciel = new Scene(Collections.<Objet3D>emptyList(), Collections.<Lampe>emptyList());
        for (int[] taille : new int[][] {{64, 32}, {32, 64}, {1, 1}, {33, 70}, {6, 3}}) {
            Lancer lancer = new Lancer(ciel, new Camera(taille[0], taille[1]));
            int[] peints = new int[1];
            lancer.TracerBrouillon((couleur, i, j) -> peints[0]++, 1, 1);
            assertEquals((taille[0] + 3) / 4 * ((taille[1] + 3) / 4), lancer.getCompteurs().primaires, taille[0] + " × " + taille[1]);
            assertEquals(taille[0] * taille[1], peints[0]);
        }
    }
}
