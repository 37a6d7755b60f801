package lancer.cours;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Collections;
import java.util.HashSet;
import java.util.Set;
import lancer.Camera;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import org.junit.jupiter.api.Test;

/** Où passe le rayon d'un pixel, au bit près. */
class CadrageTest {

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

    /** Prise en son coin, chaque couleur de l'image serait décalée d'un demi-pixel. */
    @Test
    void unPixelEstVuEnSonCentre() {
        Set<String> vus = new HashSet<>();
        Camera camera = new Camera(4, 3);
        Scene ciel = new Scene(Collections.<Objet3D>emptyList(), Collections.<Lampe>emptyList());
        new Lancer(ciel, camera).TracerPixels((couleur, i, j) -> {
            assertEquals(camera.getRayon(i + 0.5, j + 0.5).getSkyColor(), couleur);
            vus.add(i + " " + j);
        }, 0, 1);
        assertEquals(4 * 3, vus.size());
    }

    /** Une colonne d'un pixel est large de 2 : ses bouts sont vus presque d'à-plomb, sans que rien déborde. */
    @Test
    void lesBoutsDUneColonneDUnPixelSontVusPresqueDAplomb() {
        Camera camera = new Camera(1, 16384);
        Vecteur haut = camera.getRayon(0.5, 0.5).getV();
        assertEquals(16383, camera.getY(0.5), 0);
        assertEquals(1, haut.norme(), 4 * 0x1p-53);
        assertEquals(Camera.FOCALE / Math.hypot(16383, Camera.FOCALE), haut.z, 1e-18);
    }
}
