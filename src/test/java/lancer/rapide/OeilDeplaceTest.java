package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.CameraDeplacee;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

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

    /** Derrière, en plongée, au milieu des boules ou dans la plus grande, avec un champ large ou étroit. */
    @ParameterizedTest
    @CsvSource({"0, 1, 20, 0, 0, 8, 30", "3, 9, 8, 0, 0, 8, 60", "0, 0, 0, 1, 0, 0, 90", "0, 0, 8, 1, 1, 1, 150", "0, 0, 6, 0, 0, 9, 179.9",
        "-6, 0, -30, 0, 0, 8, 3", "1e9, 1e9, 1e9, 0, 0, 8, 1e-7", "5, -4, 3, 5, -4, 3.0001, 60"})
    void uneCameraPlaceeDonneAussiLImageDesBouclesDuCours(double x, double y, double z, double cx, double cy, double cz,
            double champ) {
        Point oeil = new Point(x, y, z);
        Camera camera = new CameraPlacee(LARGEUR, HAUTEUR, oeil, new Vecteur(oeil, new Point(cx, cy, cz)), champ);
        for (int foule : new int[] {12, 60}) {
            ScenesDEssai.toutes(foule).forEach((nom, scene) -> comparer(nom, scene, camera));
        }
    }

    /** Les objets d'une scène et ses lampes, tournés de cet angle autour de la verticale, puis déplacés. */
    private static Point tourner(Point p, double degres) {
        double c = Math.cos(Math.toRadians(degres));
        double s = Math.sin(Math.toRadians(degres));
        return new Point(c * p.x + s * p.z + 3, p.y - 7, c * p.z - s * p.x + 40);
    }

    private static Scene tourner(Scene scene, double degres) {
        List<Sphere> boules = new ArrayList<>();
        for (Objet3D objet : scene.getObjets()) {
            Sphere boule = new Sphere(tourner(((Sphere) objet).getCentre(), degres), ((Sphere) objet).getRayon());
            boule.setKd(objet.getKd());
            boule.setKs(objet.getKs());
            boule.setNs(objet.getNs());
            boules.add(boule);
        }
        List<Lampe> lampes = new ArrayList<>();
        scene.getLampes().forEach(lampe -> lampes.add(new Lampe(tourner(lampe.getPosition(), degres), lampe.getCouleur())));
        Point oeil = tourner(Camera.OEIL, degres);
        return new Scene(boules, lampes, (largeur, hauteur) -> new CameraPlacee(largeur, hauteur, oeil,
                new Vecteur(oeil, tourner(new Point(), degres)), Constantes.CHAMP));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 30, 45, 90, 137, 180, -100})
    void uneSceneTourneeAvecSonOeilDonneLaMemeImageAuMemePrix(double degres) {
        for (int foule : new int[] {30, 300}) {
            long[] examens = new long[2];
            Ressources.Image[] images = new Ressources.Image[2];
            for (int k = 0; k < 2; k++) {
                Scene droite = ScenesDEssai.foule(8, foule, 0).scene();
                Scene scene = k == 0 ? droite : tourner(droite, degres);
                Camera camera = scene.getCamera(LARGEUR, HAUTEUR);
                scene.getModele().setRecherche(new Preparation(scene, camera));
                Lancer traceur = new Lancer(scene, camera);
                images[k] = new Ressources.Image(LARGEUR, HAUTEUR);
                traceur.TracerPixels(images[k], 3, 1 + 2 * k);
                examens[k] = ComptesTest.cout(traceur.getCompteurs());
            }
            for (int k = 0; k < images[0].composantes.length; k++) {
                assertEquals(Math.min(1, images[0].composantes[k]), Math.min(1, images[1].composantes[k]), 1 / 255.0);
            }
            assertTrue(examens[1] < 1.15 * examens[0], examens[1] + " examens au lieu de " + examens[0]);
        }
    }

    @Test
    void leChampSeulGardeLaCameraDuCours() {
        Camera placee = new CameraPlacee(LARGEUR, HAUTEUR, Camera.OEIL, new Vecteur(0, 0, 1), Constantes.CHAMP);
        Camera cours = new Camera(LARGEUR, HAUTEUR);
        for (int k = 0; k < LARGEUR * HAUTEUR; k++) {
            Rayon attendu = cours.getRayon(k % LARGEUR + 0.5, k / LARGEUR + 0.5);
            Rayon rayon = placee.getRayon(k % LARGEUR + 0.5, k / LARGEUR + 0.5);
            assertEquals(attendu.getP(), rayon.getP());
            assertEquals(attendu.getV(), rayon.getV());
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.001, 5, 30, 90, 150, 179})
    void leChampEstLAngleDesBordsDeLEcran(double champ) {
        Camera camera = new CameraPlacee(LARGEUR, HAUTEUR, new Point(4, 5, 6), new Vecteur(-3, -8, 1), champ);
        Vecteur gauche = camera.getRayon(0, HAUTEUR / 2.0).getV();
        Vecteur droite = camera.getRayon(LARGEUR, HAUTEUR / 2.0).getV();
        assertEquals(champ, Math.toDegrees(2 * Math.asin(droite.sub(gauche).norme() / 2)), 1e-6);
        assertEquals(Constantes.ECHELLE, new Vecteur(camera.getEcran(0, 0), camera.getEcran(LARGEUR, 0)).norme(), 1e-9);
        assertEquals(camera.getEcran(0, 7).y, camera.getEcran(LARGEUR, 7).y, 1e-9, "les lignes de l'image sont horizontales");
        assertTrue(camera.getEcran(0, 0).y > camera.getEcran(0, HAUTEUR).y, "le haut de l'image est en haut");
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
            Point oeil = new Point(hasard.nextGaussian(), hasard.nextGaussian(), -0.5 - 5 * hasard.nextDouble());
            Camera[] cameras = {new Camera(LARGEUR, HAUTEUR),
                new CameraDeplacee(LARGEUR, HAUTEUR, oeil, hasard.nextDouble()),
                new CameraPlacee(LARGEUR, HAUTEUR, oeil, new Vecteur(oeil, new Point(hasard.nextGaussian(), 0, 0)), 40)};
            Camera camera = cameras[k % cameras.length];
            double xe = LARGEUR * hasard.nextDouble();
            double ye = HAUTEUR * hasard.nextDouble();
            Rayon rayon = camera.getRayon(xe, ye);
            double loin = 30 * hasard.nextDouble();
            Point p = rayon.getP().add(loin, rayon.getV());
            Point vu = camera.projeter(p);
            assertEquals(xe, vu.x, 1e-9);
            assertEquals(ye, vu.y, 1e-9);
            // un pixel plus loin sur l'écran, et autant de fois plus loin que le point l'est de l'œil
            double fois = new Vecteur(camera.getOeil(), p).norme() / new Vecteur(camera.getOeil(), rayon.getP()).norme();
            assertEquals(LARGEUR / Constantes.ECHELLE / fois, vu.z, 1e-9);
        }
    }
}
