package lancer.fenetre.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import lancer.Camera;
import lancer.Scene;
import lancer.inspection.Inspection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FigureTest {

    private static final int L = 320;
    private static final int H = 240;
    private static final int LOUPE = 16;
    private static final int CARACTERE = 12;

    @TempDir
    Path dossier;

    @Test
    void aLaLoupeLesFlechesSontAuBordDeCeQuiSeVoit() throws Exception {
        Path scene = dossier.resolve("boule.ini");
        Files.write(scene, ("[Sphere 1]\ncentre=0 0 6\nrayon=1\nKd=1 1 1\n[Lampe 1]\nposition=-4 6 -3\ncouleur=1 1 1\n"
                + "[Lampe 2]\nposition=0 0 1\ncouleur=1 1 1\n").getBytes());
        Inspection pixel = new Inspection(new Scene(scene.toString()), chose -> null, new Camera(L, H), 0, 150, 110);
        pixel.faire();
        Figure figure = new Figure(pixel);
        Dimension vue = new Dimension(300, 200);
        BufferedImage vues = peindre(figure, vue);
        BufferedImage sansBord = peindre(figure, new Dimension(LOUPE * L, LOUPE * H));
        int differents = 0;
        Rectangle loinDuBord = new Rectangle(vue);
        loinDuBord.grow(-CARACTERE, -CARACTERE);
        for (int k = 0; k < vue.width * vue.height; k++) {
            int x = k % vue.width;
            int y = k / vue.width;
            if (vues.getRGB(x, y) != sansBord.getRGB(x, y)) {
                differents++;
                assertTrue(!loinDuBord.contains(x, y), "une flèche en " + x + ", " + y);
            }
        }
        assertTrue(differents > CARACTERE, "pas de flèche au bord");
        assertEquals(vues.getRGB(1, 1), vues.getRGB(vue.width - 2, vue.height - 2), "ni là où rien ne sort");
    }

    /** Autour du pixel, sur une image où ne se voit qu'un morceau de la loupe. */
    private static BufferedImage peindre(Figure figure, Dimension vue) {
        BufferedImage image = new BufferedImage(300, 200, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, CARACTERE));
        figure.peindre(g, new Rectangle(150 - LOUPE * 150, 100 - LOUPE * 110, LOUPE * L, LOUPE * H), vue);
        g.dispose();
        return image;
    }
}
