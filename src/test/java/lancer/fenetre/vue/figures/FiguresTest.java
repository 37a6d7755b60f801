package lancer.fenetre.vue.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Collections;
import javax.swing.UIManager;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.CameraDeplacee;
import lancer.fenetre.etat.Prise;
import lancer.inspection.Inspection;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Les figures de l'inspecteur : l'anneau et les traits sur l'image, où que soit l'œil et à la loupe, et la vue de côté. */
class FiguresTest {

    private static final int L = 320;
    private static final int H = 240;
    private static final int CARACTERE = 12;
    private static final int BLANC = 200;

    private static Inspection pixel(Camera camera, int x, int y) {
        Sphere boule = new Sphere(new Point(0.2, -0.1, 6), 2.5);
        boule.setKd(new Couleur(0.8));
        Inspection pixel = new Inspection(new Scene(Collections.singletonList(boule),
                Collections.singletonList(new Lampe(new Point(0.5, 0.5, 1), new Couleur(1)))), chose -> null, camera, 0, x, y);
        pixel.faire(() -> false);
        assertTrue(pixel.getSegments().get(0).contact != null && pixel.getSegments().get(0).eclairages.get(0).eclaire());
        return pixel;
    }

    /** Une caméra d'un étudiant ou, si le plan de l'écran n'est pas donné, d'une section [Camera]. */
    private static Camera camera(double x, double y, double z, Double plan) {
        Point oeil = new Point(x, y, z);
        return plan != null ? new CameraDeplacee(L, H, oeil, plan)
                : new CameraPlacee(L, H, oeil, new Vecteur(oeil, new Point(0.3, 0, 4)), 40);
    }

    @ParameterizedTest
    @CsvSource({"0.3, 0.2, -4.2, 0, 150, 110", "0.3, 0.2, -4.2, 0, 190, 90", "-0.4, 0, -2, 0.5, 150, 130", "0, -0.6, -6, -1, 170, 120",
        "3, 1.5, -5, , 150, 110", "-4, 0.5, -3, , 165, 130", "0, 9, -6, , 160, 110"})
    void lAnneauEstAutourDuPixelEtLeTraitVaVersLaLampeLaOuElleSeVoit(double x, double y, double z, Double plan, int i, int j) {
        Camera camera = camera(x, y, z, plan);
        BufferedImage image = new BufferedImage(L, H, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, CARACTERE));
        Figure.peindre(g, pixel(camera, i, j), new AffineTransform());
        int blancs = 0;
        for (int k = 0; k < 16; k++) {
            int plusClair = 0;
            for (double rayon = 0.75 * CARACTERE - 1; rayon <= 0.75 * CARACTERE + 1; rayon += 0.25) {
                Color vu = new Color(image.getRGB((int) (i + 0.5 + rayon * Math.cos(k * Math.PI / 8)),
                        (int) (j + 0.5 + rayon * Math.sin(k * Math.PI / 8))));
                plusClair = Math.max(plusClair, Math.min(vu.getRed(), Math.min(vu.getGreen(), vu.getBlue())));
            }
            blancs += plusClair > BLANC ? 1 : 0;
        }
        assertTrue(blancs >= 12, blancs + " points blancs autour de " + i + ", " + j);
        // jaune jusqu'à la lampe
        Point lampe = Prise.projeter(camera, new Point(0.5, 0.5, 1));
        for (double part = 0.6; part < 0.95; part += 0.05) {
            assertTrue(voisins(image, i + 0.5 + part * (lampe.x - i - 0.5), j + 0.5 + part * (lampe.y - j - 0.5), false),
                    "pas de trait à la part " + part);
        }
    }

    @ParameterizedTest
    @CsvSource({"0.3, 0.2, -4.2, 0", "-0.4, 0.7, -2, 0.5", "0, -0.6, -6, -1", "3, 1.5, -5, ", "0, 9, -6, "})
    void laVueDeCoteMontreLOeilOuIlEstEtLeRayonParLePointDeLEcran(double x, double y, double z, Double plan) {
        Camera camera = camera(x, y, z, plan);
        Inspection pixel = pixel(camera, 165, 100);
        VueDeCote vue = new VueDeCote();
        vue.setSize(500, 240);
        vue.montrer(pixel);
        BufferedImage image = new BufferedImage(500, 240, BufferedImage.TYPE_INT_RGB);
        vue.paint(image.createGraphics());
        AffineTransform cadre = vue.cadrer();
        Point oeil = camera.getOeil();
        assertEquals(UIManager.getColor("Tree.textForeground").getRGB(),
                image.getRGB((int) vue.place(cadre, oeil).getX() - 2, (int) vue.place(cadre, oeil).getY()), "l'œil");
        for (double haut : new double[] {0.1, 0.5, 0.9}) {
            Point bord = camera.getEcran(0, haut * H);
            int vu = image.getRGB((int) vue.place(cadre, bord).getX(), (int) vue.place(cadre, bord).getY());
            assertTrue(new Color(vu).getRed() < BLANC, "l'écran");
        }
        Point ecran = camera.getEcran(165.5, 100.5);
        Point contact = pixel.getSegments().get(0).contact;
        for (Point passe : new Point[] {milieu(oeil, ecran), ecran, milieu(ecran, contact)}) {
            assertTrue(voisins(image, vue.place(cadre, passe).getX(), vue.place(cadre, passe).getY(), true), "le rayon en " + passe);
        }
    }

    private static Point milieu(Point a, Point b) {
        return a.add(0.5, new Vecteur(a, b));
    }

    /** Dit s'il y a du bleu, ou du jaune, à un pixel près. */
    private static boolean voisins(BufferedImage image, double x, double y, boolean bleu) {
        for (int k = 0; k < 9; k++) {
            Color vu = new Color(image.getRGB((int) x - 1 + k % 3, (int) y - 1 + k / 3));
            if (bleu ? vu.getBlue() > vu.getRed() + 60 : vu.getRed() > vu.getBlue() + 60) {
                return true;
            }
        }
        return false;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 10, 1e3, 2e4, 1e6, 1e9})
    void leBordDUneSphereEstALaHauteurDeSonEquationQuelQueSoitSonRayon(double rayon) {
        double sommet = -0.3;
        double z = 4;
        Scene scene = new Scene(Collections.singletonList(new Sphere(new Point(0, sommet - rayon, z), rayon)), Collections.emptyList());
        Inspection pixel = new Inspection(scene, chose -> null, new Camera(40, 40), 0, 20, 23);
        pixel.faire(() -> false);
        assertTrue(pixel.getSegments().get(0).contact != null);
        VueDeCote vue = new VueDeCote();
        vue.setSize(500, 180);
        vue.montrer(pixel);
        BufferedImage peinte = new BufferedImage(500, 180, BufferedImage.TYPE_INT_RGB);
        vue.paint(peinte.createGraphics());
        AffineTransform cadre = vue.cadrer();
        int jugees = 0;
        for (int x = 0; x < 500; x++) {
            double dz = (x + 0.5 - vue.place(cadre, new Point(0, 0, z)).getX())
                    / (vue.place(cadre, new Point(0, 0, 1)).getX() - vue.place(cadre, new Point()).getX());
            if (Math.abs(dz) < 0.9 * rayon) {
                double hauteur = vue.place(cadre, new Point(0, sommet - dz * dz / (rayon + Math.sqrt(rayon * rayon - dz * dz)), z)).getY();
                if (hauteur > 1 && hauteur < 178) {
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
