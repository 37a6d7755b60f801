package lancer.fenetre.figures;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Collections;
import lancer.Camera;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.inspection.Inspection;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class VueDeCoteTest {

    private static final int L = 500;
    private static final int H = 180;

    @ParameterizedTest
    @ValueSource(doubles = {1, 10, 1e3, 2e4, 1e6, 1e9})
    void leBordDUneSphereEstALaHauteurDeSonEquationQuelQueSoitSonRayon(double rayon) {
        double sommet = -0.3;
        double z = 4;
        Scene scene = new Scene(Collections.singletonList(new Sphere(new Point(0, sommet - rayon, z), rayon)), Collections.emptyList());
        Inspection pixel = new Inspection(scene, chose -> null, new Camera(40, 40), 0, 20, 23);
        pixel.faire();
        assertTrue(pixel.getSegments().get(0).contact != null);
        VueDeCote vue = new VueDeCote();
        vue.setSize(L, H);
        vue.montrer(pixel);
        BufferedImage peinte = new BufferedImage(L, H, BufferedImage.TYPE_INT_RGB);
        vue.paint(peinte.createGraphics());
        int jugees = 0;
        for (int x = 0; x < L; x++) {
            double dz = (x + 0.5 - vue.h(new Point(0, 0, z))) / (vue.h(new Point(0, 0, 1)) - vue.h(new Point()));
            if (Math.abs(dz) < 0.9 * rayon) {
                double hauteur = vue.v(new Point(0, sommet - dz * dz / (rayon + Math.sqrt(rayon * rayon - dz * dz)), z));
                if (hauteur > 1 && hauteur < H - 2) {
                    jugees++;
                    assertTrue(estGris(peinte, x, (int) (hauteur - 0.5)) || estGris(peinte, x, (int) (hauteur + 0.5)),
                            "colonne " + x + ", hauteur " + hauteur);
                }
            }
        }
        assertTrue(jugees > 15, jugees + " colonnes");
    }

    /** Un trait y passe, celui de la sphère ou un autre par-dessus lui. */
    private static boolean estGris(BufferedImage vue, int x, int y) {
        return new Color(vue.getRGB(x, y)).getRed() < 240;
    }
}
