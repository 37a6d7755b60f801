package lancer.atelier;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ImagesTest {

    @TempDir
    Path neuves;

    @TempDir
    Path dossier;

    @Test
    void seulesLesImagesDontUnPixelAChangeSontRemplacees() throws IOException {
        ecrire("meme.png", 7);
        ecrire("autre.png", 7);
        assertEquals(Arrays.asList("autre.png", "meme.png"), Images.actualiser(neuves, dossier));
        // les mêmes pixels, d'autres octets
        byte[] plus = Arrays.copyOf(Files.readAllBytes(dossier.resolve("meme.png")), 4000);
        Files.write(dossier.resolve("meme.png"), plus);
        ecrire("autre.png", 8);
        assertEquals(Collections.singletonList("autre.png"), Images.actualiser(neuves, dossier));
        assertEquals(4000, Files.size(dossier.resolve("meme.png")));
        assertEquals(Collections.emptyList(), Images.actualiser(neuves, dossier));
    }

    private void ecrire(String nom, int couleur) throws IOException {
        BufferedImage image = new BufferedImage(5, 4, BufferedImage.TYPE_INT_RGB);
        image.setRGB(3, 2, couleur);
        ImageIO.write(image, "png", neuves.resolve(nom).toFile());
    }
}
