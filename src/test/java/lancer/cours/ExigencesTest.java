package lancer.cours;

import static lancer.cours.ExigencesTripletsTest.assertCouleur;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Ombre;
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
        void cadreDeMemeAToutesLesTailles() {
            assertEquals(new Camera(800, 600).getRayon(200, 150).getP(), new Camera(1600, 1200).getRayon(400, 300).getP());
        }

        @Test
        void voitLaLargeurSousTrenteDegres() {
            Vecteur gauche = new Camera(800, 600).getRayon(0, 300).getV();
            Vecteur droite = new Camera(800, 600).getRayon(800, 300).getV();
            assertEquals(Constantes.CHAMP, Math.toDegrees(Math.acos(gauche.dot(droite))), 1e-9);
        }

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

        private double distance(double px, double py, double pz, double vx, double vy, double vz) {
            return sphere.getIntersectionDistance(new Rayon(new Point(px, py, pz), new Vecteur(vx, vy, vz)));
        }

        @Test
        void vueDeLInterieurEstToucheeALaSortie() {
            assertEquals(1, distance(0, 0, 5, 0, 0, 1), PRES);
            assertEquals(1.5, distance(0, 0, 5.5, 0, 0, -1), PRES);
        }

        @Test
        void estToucheeParSaTangente() {
            assertEquals(5, distance(1, 0, 0, 0, 0, 1), PRES);
        }

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
        private final Scene scene = new Scene(Arrays.asList(loin, pres), Collections.<Lampe>emptyList());
        private final Rayon devant = new Rayon(new Point(), new Vecteur(0, 0, 1));

        @Test
        void ignoreCeQueLeRayonRetenaitAvant() {
            pres.getIntersectionDistance(devant);
            assertEquals(8, scene.getClosestIntersection(devant, pres).distance, PRES);
        }

        @Test
        void donneLePremierDeDeuxObjetsALaMemeDistance() {
            Sphere a = new Sphere(new Point(0, 0, 5), 1);
            Sphere b = new Sphere(new Point(0, 0, 6), 2);
            assertSame(a, new Scene(Arrays.asList(a, b), scene.getLampes()).getClosestIntersection(devant).objet);
            assertSame(b, new Scene(Arrays.asList(b, a), scene.getLampes()).getClosestIntersection(devant).objet);
        }

        @Test
        void laisseDeCoteUneSphereDejaLa() {
            Sphere jumelle = new Sphere(new Point(-0.0, 0, 5), 1);
            assertEquals(1, new Scene(Arrays.asList(pres, jumelle), scene.getLampes()).getObjets().size());
        }

        @Test
        void deLaBaseSeLitDansSonFichier() {
            Scene lue = new Scene("scenes/scene1.ini");
            assertTrue(lue.getObjets().size() >= 8, "une dizaine de boules");
            assertEquals(2, lue.getLampes().size());
        }

        @Test
        void sansFichierEstFautive() {
            SceneFautive faute = assertThrows(SceneFautive.class, () -> new Scene("scenes/absente.ini"));
            assertNotNull(faute.getMessage());
        }
    }

    @Nested
    @DisplayName("Objet3D et Lampe")
    class UnObjet {

        private final Sphere boule = new Sphere(new Point(0, 0, 5), 1);
        private final Rayon devant = new Rayon(new Point(), new Vecteur(0, 0, 1));

        private Couleur couleur(int profondeur, Lampe... lampes) {
            Scene scene = new Scene(Collections.singletonList(boule), Arrays.asList(lampes));
            return boule.getColor(scene, devant, scene.getClosestIntersection(devant), profondeur);
        }

        @Test
        void sansLampeEstNoir() {
            boule.setKd(new Couleur(1));
            assertCouleur(0, 0, 0, couleur(0));
        }

        @Test
        void lampeSeMontreAvecSaPositionEtSaCouleur() {
            assertEquals("Lampe(Point(-4.0, 6.0, -3.0), Couleur(1.0, 1.0, 1.0))",
                    new Lampe(new Point(-4, 6, -3), new Couleur(1)).toString());
        }

        /** Une forme nouvelle n'a que deux méthodes à donner ; son contact est alors P + t V, tel quel. */
        @Test
        void sansPointDeSurfaceGardeSonContact() {
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
        void estDansLOmbreDUnObjetEntreLaLampeEtLui() {
            boule.setKd(new Couleur(1));
            Lampe lampe = new Lampe(new Point(0, 8, 4), new Couleur(1));
            Point contact = new Point(0, 0, 4);
            Sphere ecran = new Sphere(new Point(0, 4, 4), 1);
            Sphere derriere = new Sphere(new Point(0, 12, 4), 1);
            Sphere aCote = new Sphere(new Point(3, 4, 4), 1);
            Scene avec = new Scene(Arrays.asList(boule, ecran), Collections.singletonList(lampe));
            Scene sans = new Scene(Arrays.asList(boule, derriere, aCote), Collections.singletonList(lampe));
            assertTrue(Ombre.cachee(avec, lampe, contact, boule));
            assertTrue(!Ombre.cachee(sans, lampe, contact, boule));
        }
    }
}
