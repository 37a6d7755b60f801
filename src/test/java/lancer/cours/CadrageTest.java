package lancer.cours;

import static org.junit.jupiter.api.Assertions.assertEquals;

import lancer.Camera;
import lancer.Rayon;
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
}
