package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.essai.CameraDeplacee;
import lancer.essai.Ressources;
import lancer.fenetre.etat.Prise;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Où que soit l'œil, l'image a le même prix, et la caméra dit où un point se voit ; {@link IdentiteTest} compare les images. */
class OeilDeplaceTest {

    private static final int LARGEUR = 61;
    private static final int HAUTEUR = 47;

    /** Les objets d'une scène et ses lampes, tournés de cet angle autour de la verticale, puis déplacés. */
    private static Point tourner(Point p, double degres) {
        double c = Math.cos(Math.toRadians(degres));
        double s = Math.sin(Math.toRadians(degres));
        return new Point(c * p.x + s * p.z + 3, p.y - 7, c * p.z - s * p.x + 40);
    }

    private static Camera tourner(double degres) {
        Point oeil = tourner(Camera.OEIL, degres);
        return new CameraPlacee(LARGEUR, HAUTEUR, oeil, new Vecteur(oeil, tourner(new Point(), degres)), Constantes.CHAMP);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 30, 45, 90, 137, 180, -100})
    void uneSceneTourneeAvecSonOeilDonneLaMemeImageAuMemePrix(double degres) {
        for (int foule : new int[] {30, 300}) {
            long[] examens = new long[2];
            Ressources.Image[] images = new Ressources.Image[2];
            for (int k = 0; k < 2; k++) {
                Scene droite = ScenesDEssai.foule(8, foule, 0).scene();
                Scene scene = k == 0 ? droite : Ressources.deplacee(droite, p -> tourner(p, degres), 1);
                Camera camera = k == 0 ? new Camera(LARGEUR, HAUTEUR) : tourner(degres);
                Lancer traceur = new Lancer(Structuree.scene(scene, camera), camera);
                images[k] = new Ressources.Image(LARGEUR, HAUTEUR);
                traceur.TracerImage(images[k], 3, 1 + 2 * k);
                examens[k] = ComptesTest.cout(traceur.getAtelier().getCompteurs());
            }
            for (int k = 0; k < images[0].composantes.length; k++) {
                assertEquals(Math.min(1, images[0].composantes[k]), Math.min(1, images[1].composantes[k]), 1 / 255.0);
            }
            assertTrue(examens[1] < 1.4 * examens[0], examens[1] + " examens au lieu de " + examens[0]);
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

    /** Une carte qui ne répondrait pas laisserait tout à l'arbre, qui visite bien plus de nœuds. */
    @Test
    void surLAxeUnOeilDeplaceVaAussiViteQueLAutre() {
        for (int foule : new int[] {30, 300}) {
            long[] noeuds = new long[2];
            for (int k = 0; k < 2; k++) {
                Scene scene = ScenesDEssai.foule(8, foule, 0).scene();
                Camera camera = k == 0 ? new Camera(LARGEUR, HAUTEUR)
                        : new CameraDeplacee(LARGEUR, HAUTEUR, new Point(0, 0, -4.2), 0);
                Lancer traceur = new Lancer(Structuree.scene(scene, camera), camera);
                traceur.TracerImage((couleur, i, j) -> { }, 0, 1);
                noeuds[k] = traceur.getAtelier().getCompteurs().noeudsVisites;
            }
            assertTrue(noeuds[1] < 1.2 * noeuds[0], noeuds[1] + " nœuds au lieu de " + noeuds[0]);
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
            Point vu = Prise.projeter(camera, p);
            assertEquals(xe, vu.x, 1e-9);
            assertEquals(ye, vu.y, 1e-9);
            // un pixel plus loin sur l'écran, et autant de fois plus loin que le point l'est de l'œil
            double fois = new Vecteur(camera.getOeil(), p).norme() / new Vecteur(camera.getOeil(), rayon.getP()).norme();
            assertEquals(LARGEUR / Constantes.ECHELLE / fois, vu.z, 1e-9);
        }
    }
}
