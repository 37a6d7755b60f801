package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.essai.CameraDeplacee;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Où que soit l'œil, la recherche rapide donne l'image des boucles du cours, et la caméra dit où un point se voit. */
class OeilDeplaceTest {

    private static final int LARGEUR = 61;
    private static final int HAUTEUR = 47;

    private static void comparer(String cas, Scene scene, Camera camera) {
        Scene simple = scene.avec(scene.getModele());
        Ressources.Image attendue = new Ressources.Image(LARGEUR, HAUTEUR);
        new Lancer(simple, camera).TracerPixels(attendue, 3, 2);
        assertTrue(Ressources.memesBits(attendue, Ressources.imageRapide(scene, camera, 3)), cas);
    }

    @ParameterizedTest
    @CsvSource({"0.3, 0.2, -4.2, 0", "-2, 1.5, -3, 0", "0, 0, -1, 0", "0, 0, -0.3, 0.5", "0.4, 0, -0.01, 0", "0, 0, -500, 0",
        "-300, 20, -40, 1", "0, 0, -0.51, 0", "0, 0, -0.49, 0", "0, 0, -30, 0",
        "0.1, 0.2, 0, 0", "0, 0, 3, 0", "1, -2, 5, -1", "0, 0, -1e9, 0", "1e120, 0, -1, 0", "0, 0, NaN, 0"})
    void lImageEstCelleDesBouclesDuCours(double x, double y, double z, double plan) {
        Camera camera = new CameraDeplacee(LARGEUR, HAUTEUR, new Point(x, y, z), plan);
        if (z != plan && z == z) {
            for (int foule : new int[] {12, 60}) {
                for (Map.Entry<String, Scene> e : ScenesDEssai.toutes(foule).entrySet()) {
                    comparer(e.getKey(), e.getValue(), camera);
                }
            }
        } else {
            // il y a des rayons qui n'existent pas : la préparation n'en échoue pas
            new Preparation(ScenesDEssai.foule(3, 60, 0).scene(), camera);
        }
    }

    @Test
    void deCentCinquanteYeuxAuHasardAussi() {
        Random hasard = new Random(42);
        for (int k = 0; k < 150; k++) {
            double cote = k % 4 == 0 ? 1 : 0;
            Point oeil = new Point(cote * hasard.nextGaussian(), cote * hasard.nextGaussian(),
                    -Math.pow(10, 3 * hasard.nextDouble() - 1.5));
            double plan = k % 8 == 0 ? hasard.nextGaussian() : 0;
            comparer("tirage " + k + " : " + oeil + ", " + plan, ScenesDEssai.foule(k, k % 2 == 0 ? 30 : 200, 0).scene(),
                    new CameraDeplacee(LARGEUR, HAUTEUR, oeil, plan));
        }
    }

    /** Une carte qui ne répondrait pas laisserait tout à l'arbre, qui visite bien plus de nœuds. */
    @Test
    void surLAxeUnOeilDeplaceVaAussiViteQueLAutre() {
        for (int foule : new int[] {30, 300}) {
            long[] noeuds = new long[2];
            for (int k = 0; k < 2; k++) {
                Scene scene = ScenesDEssai.foule(8, foule, 0).scene();
                Camera camera = k == 0 ? new Camera(LARGEUR, HAUTEUR)
                        : new CameraDeplacee(LARGEUR, HAUTEUR, new Point(0, 0, -4.2), 0);
                scene.getModele().setRecherche(new Preparation(scene, camera));
                Lancer traceur = new Lancer(scene, camera);
                traceur.TracerPixels((couleur, i, j) -> { }, 0, 1);
                noeuds[k] = traceur.getCompteurs().noeudsVisites;
            }
            assertTrue(noeuds[1] < 1.2 * noeuds[0], noeuds[1] + " nœuds au lieu de " + noeuds[0]);
        }
    }

    /** Il voit ce qui est derrière l'écran : sans rien tenir pour acquis, la recherche n'a pas à être remplacée. */
    @Test
    void unOeilDevantLEcranNEgarePasLaRecherche() {
        Random hasard = new Random(5);
        for (int foule : new int[] {30, 300}) {
            List<Sphere> boules = new ArrayList<>();
            for (int k = 0; k < foule; k++) {
                boules.add(new Sphere(new Point(4 * hasard.nextDouble() - 2, 4 * hasard.nextDouble() - 2, -4 - 4 * hasard.nextDouble()),
                        0.4));
            }
            Scene scene = new Scene(boules, Collections.emptyList());
            Camera camera = new CameraDeplacee(LARGEUR, HAUTEUR, new Point(0, 0, 3), 0);
            comparer(foule + " boules", scene, camera);
        }
    }

    @Test
    void unPointDUnRayonSeVoitLaOuLeRayonPasse() {
        Random hasard = new Random(7);
        for (int k = 0; k < 1000; k++) {
            Camera camera = k == 0 ? new Camera(LARGEUR, HAUTEUR) : new CameraDeplacee(LARGEUR, HAUTEUR,
                    new Point(hasard.nextGaussian(), hasard.nextGaussian(), -0.5 - 5 * hasard.nextDouble()), hasard.nextDouble());
            double xe = LARGEUR * hasard.nextDouble();
            double ye = HAUTEUR * hasard.nextDouble();
            Rayon rayon = camera.getRayon(xe, ye);
            double loin = 30 * hasard.nextDouble();
            Point p = rayon.getP().add(loin, rayon.getV());
            Point vu = camera.projeter(p);
            assertEquals(xe, vu.x, 1e-9);
            assertEquals(ye, vu.y, 1e-9);
            // un pixel plus loin sur l'écran, et autant de fois plus loin que le point l'est de l'œil
            double fois = (p.z - camera.getOeil().z) / (rayon.getP().z - camera.getOeil().z);
            assertEquals(LARGEUR / Constantes.ECHELLE / fois, vu.z, 1e-9);
        }
    }
}
