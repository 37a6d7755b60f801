package lancer.cours;

import static lancer.cours.ExigencesTripletsTest.assertCouleur;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Plan;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;

/** Ce que le programme promet des rayons, de la caméra, des objets et de la scène, au-delà de ce que le cours demande. */
class ExigencesTest {

    private static final double PRES = 1e-12;

    @Nested
    @DisplayName("Rayon")
    class UnRayon {

        @Test
        void sansDirectionEstRefuse() {
            assertThrows(ArithmeticException.class, () -> new Rayon(new Point(1, 2, 3), new Point(1, 2, 3)));
            assertThrows(ArithmeticException.class, () -> new Rayon(new Point(), new Vecteur()));
        }

        @Test
        void neufNeToucheRien() {
            Rayon rayon = new Rayon(new Point(), new Vecteur(0, 0, 1));
            assertEquals(Constantes.INFINI, rayon.getDistance());
            assertNull(rayon.getObjet());
            assertNull(rayon.calcContact());
        }

        @Test
        void versLeHautVoitLeCielBleu() {
            assertCouleur(0, 0, 1, new Rayon(new Point(), new Vecteur(0, 1, 0)).getSkyColor());
            assertCouleur(0.28, 0.28, 1, new Rayon(new Point(), new Vecteur(0, 0.6, 0.8)).getSkyColor());
        }

        @Test
        void versLeBasOuLHorizonVoitLaTerre() {
            assertCouleur(0.5, 0.4, 0.1, new Rayon(new Point(), new Vecteur(0, 0, 1)).getSkyColor());
            assertCouleur(0.5, 0.2, 0.1, new Rayon(new Point(), new Vecteur(0, -1, 0)).getSkyColor());
        }
    }

    @Nested
    @DisplayName("Camera")
    class UneCamera {

        @Test
        void sansPixelEstRefusee() {
            for (int[] taille : new int[][] {{0, 600}, {0, 1}, {1, 0}, {-1, 5}}) {
                assertThrows(IllegalArgumentException.class, () -> new Camera(taille[0], taille[1]));
            }
        }
    }

    @Nested
    @DisplayName("Sphere")
    class UneSphere {

        private final Sphere sphere = new Sphere(new Point(0, 0, 5), 1);

        @Test
        void noteDansLeRayonCeQuElleTrouveMemeRien() {
            Rayon rayon = new Rayon(new Point(), new Vecteur(0, 0, 1));
            sphere.getIntersectionDistance(rayon);
            assertSame(sphere, rayon.getObjet());
            assertEquals(4, rayon.getDistance(), PRES);
            new Sphere(new Point(9, 9, 9), 1).getIntersectionDistance(rayon);
            assertNull(rayon.getObjet());
            assertEquals(Constantes.INFINI, rayon.getDistance());
        }

        @Test
        void aUnRayonFiniEtPlusGrandQueZero() {
            for (double rayon : new double[] {Double.MAX_VALUE, Double.MIN_VALUE}) {
                assertEquals(rayon, new Sphere(new Point(), rayon).getRayon());
            }
            for (double rayon : new double[] {0, -0.0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
                assertThrows(IllegalArgumentException.class, () -> new Sphere(new Point(), rayon));
            }
        }

        @Test
        void seMontreAvecSonCentreEtSonRayon() {
            assertEquals("Sphere(Point(0.0, 0.5, 6.0), 1.0)", new Sphere(new Point(0, 0.5, 6), 1).toString());
        }
    }

    @Nested
    @DisplayName("Scene")
    class UneScene {

        private final Sphere pres = new Sphere(new Point(0, 0, 5), 1);
        private final Sphere loin = new Sphere(new Point(0, 0, 9), 1);
        private final Scene scene = new Scene(List.of(loin, pres), List.of());
        private final Rayon devant = new Rayon(new Point(), new Vecteur(0, 0, 1));

        @Test
        void ignoreCeQueLeRayonRetenaitAvant() {
            pres.getIntersectionDistance(devant);
            assertEquals(8, scene.getClosestIntersection(devant, pres).distance, PRES);
        }

        @Test
        void deLaBaseSeLitDansSonFichier() {
            Scene lue = new Scene("scenes/scene1.ini");
            assertTrue(lue.getObjets().size() >= 8, "une dizaine de boules");
            assertEquals(2, lue.getLampes().size());
        }
    }

    @Nested
    @DisplayName("Objet3D et Lampe")
    class UnObjet {

        @Test
        void lampeSeMontreAvecSaPositionEtSaCouleur() {
            assertEquals("Lampe(Point(-4.0, 6.0, -3.0), Couleur(1.0, 1.0, 1.0))",
                    new Lampe(new Point(-4, 6, -3), new Couleur(1)).toString());
        }

        /** Une forme nouvelle n'a que deux méthodes à donner ; son contact est alors P + t V, tel quel. */
        @Test
        void sansPointDeSurfaceGardeSonContact() {
            Objet3D plan = new Plan(new Point(0, 0, 7), new Vecteur(0, 0, -1));
            Rayon rayon = new Rayon(new Point(1, 2, 3), new Point(1, 5, 7));
            plan.getIntersectionDistance(rayon);
            PointContact contact = rayon.calcContact();
            assertSame(plan, contact.objet);
            assertEquals(rayon.getP().add(rayon.getV().mul(5)), new Point(contact.x, contact.y, contact.z));
        }
    }
}
