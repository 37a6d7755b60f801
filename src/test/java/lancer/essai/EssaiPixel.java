package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;

/** De quoi comparer les pixels que {@code --pixel} dit un par un à ceux de l'image entière. */
public final class EssaiPixel {

    private static final int AU_HASARD = 6;

    private EssaiPixel() {
    }

    /**
     * Les coins, les bords d'un pavé et quelques autres pixels de cette scène sont ceux du PFM et du PNG, au bit près.
     *
     * @param classes voir {@link Essai#executerAvec}
     */
    public static void verifier(List<Path> classes, Path dossier, Path scene, int largeur, int hauteur, String... options)
            throws IOException {
        String[] communs = Essai.suite(options, "--taille", largeur + "x" + hauteur, scene.toString());
        Path png = dossier.resolve("image.png");
        Path pfm = dossier.resolve("image.pfm");
        try (Essai.Isole programme = new Essai.Isole(classes)) {
            Essai image = programme.executer(Essai.suite(communs, "--image=" + png, "--lineaire=" + pfm));
            assertEquals(0, image.code, image.toString());
            float[] lineaire = Essai.pfm(Files.readAllBytes(pfm));
            BufferedImage codes = ImageIO.read(png.toFile());
            Random hasard = new Random(largeur);
            int[] xs = {0, largeur - 1, 31, 32};
            int[] ys = {0, hauteur - 1, 31, 32};
            for (int k = 0; k < 16 + AU_HASARD; k++) {
                int x = Math.min(largeur - 1, k < 16 ? xs[k % 4] : hasard.nextInt(largeur));
                int y = Math.min(hauteur - 1, k < 16 ? ys[k / 4] : hasard.nextInt(hauteur));
                Essai pixel = programme.executer(Essai.suite(communs, "--pixel=" + x + "," + y));
                assertEquals(image.erreur, pixel.erreur);
                assertEquals(0, pixel.code);
                String[] lignes = pixel.sortie.split(System.lineSeparator());
                String[] mots = lignes[lignes.length - 1].split(" ");
                float[] dits = {Float.NaN, Float.NaN, Float.NaN};
                for (int c = 0; c < 3; c++) {
                    dits[c] = (float) Double.parseDouble(mots[1 + c]);
                }
                int debut = 3 * ((hauteur - 1 - y) * largeur + x);
                String cas = "pixel " + x + ", " + y + " de " + scene;
                assertEquals(Arrays.toString(Arrays.copyOfRange(lineaire, debut, debut + 3)), Arrays.toString(dits), cas);
                assertEquals(String.format("#%06X", codes.getRGB(x, y) & 0xFFFFFF), mots[5], cas);
            }
        }
    }
}
