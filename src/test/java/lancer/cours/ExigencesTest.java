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
    void laSceneDeLaBaseSeLitDansSonFichier() {
        Scene lue = new Scene("scenes/scene1.ini");
        assertTrue(lue.getObjets().size() >= 8, "une dizaine de boules");
        assertEquals(2, lue.getLampes().size());
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
