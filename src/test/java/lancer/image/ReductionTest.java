package lancer.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import lancer.Couleur;
import org.junit.jupiter.api.Test;

/** Une image réduite est la moyenne de ses pixels, pondérés par la surface qu'en couvre chaque pixel réduit. */
class ReductionTest {

    private static ImageMemoire rayures(int largeur, int hauteur) {
        ImageMemoire image = new ImageMemoire(largeur, hauteur, false);
        for (int k = 0; k < largeur * hauteur; k++) {
            image.drawPixel(new Couleur(k % largeur % 2, k / largeur % 2, 0.2), k % largeur, k / largeur);
        }
        return image;
    }

    @Test
    void uneTrameDUnPixelDevientUnGrisSansFauxMotif() {
        int[] codes = Reduction.moyenne(rayures(64, 48), 16, 12, 1);
        for (int code : codes) {
            assertEquals(0xFF808033, code);
        }
    }

    @Test
    void unPixelACheminEstPartageSelonSaSurface() {
        ImageMemoire image = new ImageMemoire(3, 1, false);
        image.drawPixel(new Couleur(1), 0, 0);
        image.drawPixel(new Couleur(0), 1, 0);
        image.drawPixel(new Couleur(0), 2, 0);
        // un pixel et demi chacun : le premier couvre le blanc aux deux tiers
        assertArrayEquals(new int[] {0xFFAAAAAA, 0xFF000000}, Reduction.moyenne(image, 2, 1, 1));
    }

    @Test
    void ceQuiNEstPasDessineNAssombritPasLeReste() {
        ImageMemoire image = new ImageMemoire(4, 1, false);
        image.drawPixel(new Couleur(1), 0, 0);
        assertArrayEquals(new int[] {0xFFFFFFFF, 0}, Reduction.moyenne(image, 2, 1, 1));
    }
}
