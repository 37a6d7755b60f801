package lancer.atelier;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** docs/reponses.md et ses figures. */
class ReponsesTest {

    private static String lire(String fichier) throws IOException {
        return new String(Files.readAllBytes(Paths.get("..", fichier)), StandardCharsets.UTF_8);
    }

    @Test
    void lesNombresDeLaPageSontCeuxDuProgramme() throws IOException {
        String page = lire("docs/reponses.md");
        assertEquals(PagesMesurees.remplacer(page, Reponses.valeurs()), page, "make reponses");
    }

    @Test
    void lesFiguresSontCellesDuProgramme() throws IOException {
        assertEquals(Reponses.cosinus(), lire("images/reponses-cosinus.svg"), "make reponses");
        memes(Reponses.etapes(), "images/reponses-etapes.png");
        memes(Reponses.escaliers(), "images/reponses-escaliers.png");
    }

    /** À un niveau près : les fonctions de Java n'arrondissent pas de même sur toutes les machines. */
    private static void memes(BufferedImage attendue, String fichier) throws IOException {
        BufferedImage image = ImageIO.read(new File("..", fichier));
        assertEquals(attendue.getWidth() + "x" + attendue.getHeight(), image.getWidth() + "x" + image.getHeight());
        int differents = 0;
        for (int k = 0; k < image.getWidth() * image.getHeight(); k++) {
            int a = attendue.getRGB(k % image.getWidth(), k / image.getWidth());
            int b = image.getRGB(k % image.getWidth(), k / image.getWidth());
            for (int d = 0; d < 24; d += 8) {
                differents += Math.abs((a >> d & 255) - (b >> d & 255)) > 1 ? 1 : 0;
            }
        }
        assertEquals(0, differents, fichier + " n'est plus du programme : make reponses");
    }
}
