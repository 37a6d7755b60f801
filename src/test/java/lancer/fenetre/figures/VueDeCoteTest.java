package lancer.fenetre.figures;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import lancer.Camera;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.inspection.Inspection;
import lancer.scene.Origines;
import org.junit.jupiter.api.Test;
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
        Inspection pixel = new Inspection(scene, new Origines(), new Camera(40, 40), 0, 20, 23);
        pixel.faire();
        assertTrue(pixel.getSegments().get(0).contact != null);
        VueDeCote vue = new VueDeCote(numero -> { });
        vue.setSize(L, H);
        vue.montrer(pixel, 0);
        BufferedImage peinte = new BufferedImage(L, H, BufferedImage.TYPE_INT_RGB);
        vue.paint(peinte.createGraphics());
        int jugees = 0;
        for (int x = 0; x < L; x++) {
            double dz = (x + 0.5 - vue.h(z)) / (vue.h(1) - vue.h(0));
            if (Math.abs(dz) < 0.9 * rayon) {
                double hauteur = vue.v(sommet - dz * dz / (rayon + Math.sqrt(rayon * rayon - dz * dz)));
                if (hauteur > 1 && hauteur < H - 2) {
                    jugees++;
                    assertTrue(estGris(peinte, x, (int) (hauteur - 0.5)) || estGris(peinte, x, (int) (hauteur + 0.5)),
                            "colonne " + x + ", hauteur " + hauteur);
                }
            }
        }
        assertTrue(jugees > 15, jugees + " colonnes");
    }

    @Test
    void unRebondSeVoitDePlusPresQueTousEnsemble() {
        Random hasard = new Random(31);
        for (int essai = 0; essai < 300; essai++) {
            List<Sphere> spheres = new ArrayList<>();
            for (int k = 0; k < 12; k++) {
                Sphere sphere = new Sphere(new Point(2 - 4 * hasard.nextDouble(), 2 - 4 * hasard.nextDouble(),
                        1 + 4 * hasard.nextDouble()), 0.7);
                sphere.setKs(new Couleur(0.9));
                spheres.add(sphere);
            }
            Inspection pixel = new Inspection(new Scene(spheres, Collections.emptyList()), new Origines(), new Camera(41, 41), 5, 20, 20);
            pixel.faire();
            VueDeCote vue = new VueDeCote(numero -> { });
            vue.setSize(170, 50);
            vue.montrer(pixel, 2);
            vue.paint(new BufferedImage(170, 50, BufferedImage.TYPE_INT_RGB).createGraphics());
            Set<Objet3D> voisines = new HashSet<>();
            pixel.getSegments().stream().filter(segment -> segment.numero <= 3 && segment.contact != null)
                    .forEach(segment -> voisines.add(segment.contact.objet));
            double pres = vue.h(1) - vue.h(0);
            vue.montrer(pixel, 0);
            vue.paint(new BufferedImage(170, 50, BufferedImage.TYPE_INT_RGB).createGraphics());
            assertTrue(pres > vue.h(1) - vue.h(0) || voisines.size() < 2, "de près, " + pres + " pixels par unité");
        }
    }

    /** Un trait y passe, celui de la sphère ou un autre par-dessus lui. */
    private static boolean estGris(BufferedImage vue, int x, int y) {
        return new Color(vue.getRGB(x, y)).getRed() < 240;
    }
}
