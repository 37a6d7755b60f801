package lancer.cours;

import static lancer.cours.ExigencesTripletsTest.assertCouleur;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

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
import org.junit.jupiter.api.Test;

/** Ce que le programme promet des rayons, de la caméra, des objets et de la scène, au-delà de ce que le cours demande. */
class ExigencesTest {

    private static final double PRES = 1e-12;

    private final Rayon devant = new Rayon(new Point(), new Vecteur(0, 0, 1));
    private final Sphere pres = new Sphere(new Point(0, 0, 5), 1);

    @Test
    void unRayonSansDirectionEstRefuse() {
        assertThrows(ArithmeticException.class, () -> new Rayon(new Point(1, 2, 3), new Point(1, 2, 3)));
        assertThrows(ArithmeticException.class, () -> new Rayon(new Point(), new Vecteur()));
    }

    @Test
    void unRayonNeufNeToucheRien() {
        assertEquals(Constantes.INFINI, devant.getDistance());
        assertNull(devant.getObjet());
        assertNull(devant.calcContact());
    }

    private static Couleur ciel(double y, double z) {
        return new Rayon(new Point(), new Vecteur(0, y, z)).getSkyColor();
    }

    @Test
    void unRayonVoitLeCielBleuVersLeHautEtLaTerreVersLeBasOuLHorizon() {
        assertCouleur(0, 0, 1, ciel(1, 0));
        assertCouleur(0.28, 0.28, 1, ciel(0.6, 0.8));
        assertCouleur(0.5, 0.4, 0.1, ciel(0, 1));
        assertCouleur(0.5, 0.2, 0.1, ciel(-1, 0));
    }

    @Test
    void uneCameraSansPixelEstRefusee() {
        for (int[] taille : new int[][] {{0, 600}, {0, 1}, {1, 0}, {-1, 5}}) {
            assertThrows(IllegalArgumentException.class, () -> new Camera(taille[0], taille[1]));
        }
    }

    @Test
    void lePixelDuMilieuDUneImageImpaireRegardeExactementDansLAxe() {
        for (int[] taille : new int[][] {{1, 1}, {3, 3}, {101, 77}, {1, 9999}, {9999, 1}, {16383, 11}}) {
            Rayon rayon = new Camera(taille[0], taille[1]).getRayon(taille[0] / 2.0, taille[1] / 2.0);
            assertEquals(0, rayon.getP().x + rayon.getP().y + rayon.getP().z, 0);
            assertEquals(0, Math.abs(rayon.getV().x) + Math.abs(rayon.getV().y), 0);
            assertEquals(1, rayon.getV().z, 0);
        }
    }

    @Test
    void desPixelsOpposesOntDesRayonsExactementOpposes() {
        for (int[] taille : new int[][] {{101, 77}, {100, 76}, {1, 500}, {799, 3}}) {
            Camera camera = new Camera(taille[0], taille[1]);
            for (int i = 0; i < taille[0]; i++) {
                for (int j = 0; j < taille[1]; j++) {
                    Vecteur v = camera.getRayon(i + 0.5, j + 0.5).getV();
                    Vecteur oppose = camera.getRayon(taille[0] - 1 - i + 0.5, taille[1] - 1 - j + 0.5).getV();
                    assertEquals(0, Math.abs(v.x + oppose.x) + Math.abs(v.y + oppose.y) + Math.abs(v.z - oppose.z), 0);
                }
            }
        }
    }

    @Test
    void uneSphereNoteDansLeRayonCeQuElleTrouveMemeRien() {
        pres.getIntersectionDistance(devant);
        assertSame(pres, devant.getObjet());
        assertEquals(4, devant.getDistance(), PRES);
        new Sphere(new Point(9, 9, 9), 1).getIntersectionDistance(devant);
        assertNull(devant.getObjet());
        assertEquals(Constantes.INFINI, devant.getDistance());
    }

    @Test
    void uneSphereAUnRayonFiniEtPlusGrandQueZero() {
        for (double rayon : new double[] {Double.MAX_VALUE, Double.MIN_VALUE}) {
            assertEquals(rayon, new Sphere(new Point(), rayon).getRayon());
        }
        for (double rayon : new double[] {0, -0.0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> new Sphere(new Point(), rayon));
        }
    }

    @Test
    void uneSceneIgnoreCeQueLeRayonRetenaitAvant() {
        Scene scene = new Scene(List.of(new Sphere(new Point(0, 0, 9), 1), pres), List.of());
        pres.getIntersectionDistance(devant);
        assertEquals(8, scene.getClosestIntersection(devant, pres).distance, PRES);
    }

    @Test
    void chacunSeMontreAvecSaClasseEtCeQuIlContient() {
        assertEquals("Vecteur(1.0, 0.0, -2.5)", new Vecteur(1, 0, -2.5).toString());
        assertEquals("Couleur(0.9, 0.15, 0.1)", new Couleur(0.9, 0.15, 0.1).toString());
        assertEquals("Sphere(Point(0.0, 0.5, 6.0), 1.0)", new Sphere(new Point(0, 0.5, 6), 1).toString());
        assertEquals("Lampe(Point(-4.0, 6.0, -3.0), Couleur(1.0, 1.0, 1.0))", new Lampe(new Point(-4, 6, -3), new Couleur(1)).toString());
    }

    /** Une forme nouvelle n'a que deux méthodes à donner ; son contact est alors P + t V, tel quel. */
    @Test
    void unObjetSansPointDeSurfaceGardeSonContact() {
        Objet3D plan = new Plan(new Point(0, 0, 7), new Vecteur(0, 0, -1));
        Rayon rayon = new Rayon(new Point(1, 2, 3), new Point(1, 5, 7));
        plan.getIntersectionDistance(rayon);
        PointContact contact = rayon.calcContact();
        assertSame(plan, contact.objet);
        assertEquals(rayon.getP().add(rayon.getV().mul(5)), new Point(contact.x, contact.y, contact.z));
    }
}
