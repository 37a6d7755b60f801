package lancer.antialias;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.CameraDeplacee;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Les boules que la méthode {@code partage} ne doit pas manquer sont là où l'œil de la caméra les voit. */
class OeilDeplacePetitesTest {

    private static final int L = 60;
    private static final int H = 45;
    private static final int FIN = 8;

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void touteBouleQuiPasseEntreLesCoinsDUnPixelPeutYEchapper(boolean placee) {
        Camera camera = placee ? new CameraPlacee(L, H, new Point(3, 8, 9), new Vecteur(-2, -5, -3), 30)
                : new CameraDeplacee(L, H, new Point(0.3, 0.2, -4.2), 0.1);
        Random hasard = new Random(3);
        List<Objet3D> boules = new ArrayList<>();
        for (int k = 0; k < 40; k++) {
            Rayon rayon = camera.getRayon(L * hasard.nextDouble(), H * hasard.nextDouble());
            boules.add(new Sphere(rayon.getP().add(3 + 2 * hasard.nextDouble(), rayon.getV()), 0.02));
        }
        Scene scene = new Scene(boules, Collections.emptyList());
        Petites petites = new Petites(boules, camera);
        int vus = 0;
        int pixels = 0;
        for (int p = 0; p < L * H; p++) {
            int i = p % L;
            int j = p / L;
            pixels += petites.peutEchapper(i, j, i + 1, j + 1) ? 1 : 0;
            for (int k = 0; k < FIN * FIN; k++) {
                if (scene.getClosestIntersection(camera.getRayon(i + (k % FIN + 0.5) / FIN, j + (k / FIN + 0.5) / FIN)) != null) {
                    vus++;
                    assertTrue(petites.peutEchapper(i, j, i + 1, j + 1), "pixel " + i + ", " + j);
                }
            }
        }
        assertTrue(vus > 100, vus + " points");
        assertTrue(pixels < L * H / 10, pixels + " pixels");
    }
}
