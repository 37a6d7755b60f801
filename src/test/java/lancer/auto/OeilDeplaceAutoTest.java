package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import lancer.Camera;
import lancer.Lancer;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.essai.CameraDeplacee;
import org.junit.jupiter.api.Test;

/** Les petits objets de {@code --auto} sont là où l'œil de la caméra les voit. */
class OeilDeplaceAutoTest {

    private static final int L = 60;
    private static final int H = 45;
    private static final int FIN = 8;

    @Test
    void toutPixelOuSeVoitUnePetiteBouleEstMarque() {
        Camera camera = new CameraDeplacee(L, H, new Point(0.3, 0.2, -4.2), 0.1);
        Random hasard = new Random(3);
        List<Sphere> boules = new ArrayList<>();
        for (int k = 0; k < 30; k++) {
            Rayon rayon = camera.getRayon(L * hasard.nextDouble(), H * hasard.nextDouble());
            boules.add(new Sphere(rayon.getP().add(3 + 2 * hasard.nextDouble(), rayon.getV()), 0.02));
        }
        Scene scene = new Scene(boules, Collections.emptyList());
        EchantillonPilote pilote = new EchantillonPilote(new Essais(new Lancer(scene, camera), 1), 1e6);
        int vus = 0;
        for (int k = 0; k < L * FIN * H * FIN; k++) {
            int x = k % (L * FIN);
            int y = k / (L * FIN);
            if (scene.getClosestIntersection(camera.getRayon((x + 0.5) / FIN, (y + 0.5) / FIN)) != null) {
                vus++;
                assertTrue(pilote.petits.get(y / FIN * L + x / FIN), "pixel " + x / FIN + ", " + y / FIN);
            }
        }
        assertTrue(vus > 100, vus + " points");
        assertTrue(pilote.petits.cardinality() < L * H / 10, pilote.petits.cardinality() + " pixels");
    }
}
