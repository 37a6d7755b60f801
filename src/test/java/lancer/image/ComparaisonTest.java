package lancer.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import lancer.essai.Essai;
import lancer.essai.EssaiCommande;
import org.junit.jupiter.api.Test;

/** {@code --comparer} : deux images, ou une image et une scène dessinée à l'instant. */
class ComparaisonTest extends EssaiCommande {

    private Essai comparer(Object reference, Object autre, String... options) {
        return Essai.executer(Essai.suite(options, "--comparer", reference.toString(), autre.toString()));
    }

    private static void verifierPareilles(Essai e) {
        verifier(0, "pareilles", e);
    }

    private static void verifierDifferentes(Essai e) {
        verifier(1, "différentes", e);
    }

    private static void verifier(int statut, String dit, Essai e) {
        assertEquals("", e.erreur);
        assertEquals(statut, e.code, e.toString());
        assertTrue(e.sortie.startsWith("images: " + dit), e.sortie);
    }

    @Test
    void uneSceneEstPareilleAuxImagesQuElleADonnees() {
        dessiner("--image", png.toString(), "--lineaire", pfm.toString());
        verifierPareilles(comparer(png, SCENE));
        verifierPareilles(comparer(pfm, SCENE));
        verifierPareilles(comparer(pfm, SCENE, "--simple"));
        verifierPareilles(comparer(png, pfm));
        verifierPareilles(comparer(pfm, png));
    }

    @Test
    void desCentainesDeMilliersDePixelsSArrondissentCommeDansLePng() {
        assertEquals(0, Essai.executer("--image", png.toString(), "scenes/scene1.ini").code);
        verifierPareilles(comparer(png, "scenes/scene1.ini"));
    }

    @Test
    void uneReflexionDeMoinsSeVoitDansLeStatutEtDansLesNombres() {
        dessiner("--image", png.toString());
        Essai e = comparer(png, SCENE, "--reflets", "0");
        verifierDifferentes(e);
        assertTrue(e.sortie.matches("(?s).*écart quadratique moyen: \\d+\\.\\d{4}\\R.*"
                + "plus grand écart: \\d+\\.\\d{4} en \\d+,\\d+\\R.*sur 1200.*"), e.sortie);
    }

    @Test
    void unNiveauDeDifferenceEstPermisSiOnLeDemande() throws IOException {
        ecrire("a.png", 10, 20, 30);
        ecrire("b.png", 11, 20, 29);
        ecrire("c.png", 12, 20, 30);
        Path a = dossier.resolve("a.png");
        Path b = dossier.resolve("b.png");
        verifierDifferentes(comparer(a, b));
        assertTrue(comparer(a, b).sortie.contains("plus grand écart: 1.0000 en 3,2"));
        verifierPareilles(comparer(a, b, "--tolerance", "1"));
        verifierDifferentes(comparer(a, dossier.resolve("c.png"), "--tolerance", "1"));
    }

    @Test
    void unePartDesPixelsPeutPasserLaTolerance() throws IOException {
        BufferedImage image = new BufferedImage(100, 10, BufferedImage.TYPE_INT_RGB);
        ImageIO.write(image, "png", png.toFile());
        for (int k = 0; k < 7; k++) {
            image.setRGB(10 * k, k, 0x050000);
        }
        Path autre = dossier.resolve("sept.png");
        ImageIO.write(image, "png", autre.toFile());
        // sept pixels sur mille, ni plus ni moins
        for (String assez : new String[] {"0.7%", "0.007", "7e-3", "7e-1%", "1", "100%"}) {
            verifierPareilles(comparer(png, autre, "--part", assez));
            verifierPareilles(comparer(png, autre, "--tolerance", "4", "--part", assez));
        }
        for (String peu : new String[] {"0", "0%", "0.0069", "0.69%"}) {
            verifierDifferentes(comparer(png, autre, "--part=" + peu));
            verifierPareilles(comparer(png, autre, "--part=" + peu, "--tolerance=5"));
        }
        assertTrue(comparer(png, autre, "--part", "1%").sortie.contains("pixels au-delà de la tolérance: 7 sur 1000"));
        for (String fausse : new String[] {"-1", "1.5", "101%", "%", "0.5 %", "0,5%", "1e999%", "NaN"}) {
            verifierDemandeFausse("--part", comparer(png, autre, "--part=" + fausse));
        }
        verifierDemandeFausse("--part ne sert pas seule", Essai.executer("--part", "0.1", SCENE));
    }

    /** Une image de quatre mille pixels sur trois mille, que l'on n'a pas de quoi tenir en mémoire. */
    @Test
    void uneImageTropGrandePourLaMemoireEstUnePanneEtNonUneImageAbimee() throws Exception {
        ImageIO.write(new BufferedImage(4000, 3000, BufferedImage.TYPE_INT_RGB), "png", png.toFile());
        Process p = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx24m",
                "-Dfile.encoding=UTF-8", "-cp", System.getProperty("java.class.path"), "lancer.Main", "--comparer", png.toString(),
                png.toString()).redirectErrorStream(true).start();
        String dit = new String(p.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(1, p.waitFor(), dit);
        assertTrue(dit.matches("lancer : .*mémoire.*\\R"), dit);
    }

    @Test
    void unPfmDontLEnteteFinitSesLignesParCrlfLeDit() throws IOException {
        byte[] entete = "PF\r\n1 1\r\n-1.0\r\n".getBytes("US-ASCII");
        Files.write(pfm, Arrays.copyOf(entete, entete.length + 12));
        verifierDemandeFausse("CRLF", comparer(pfm, pfm));
    }

    private void ecrire(String nom, int r, int v, int b) throws IOException {
        BufferedImage image = new BufferedImage(7, 5, BufferedImage.TYPE_INT_RGB);
        image.setRGB(3, 2, r << 16 | v << 8 | b);
        ImageIO.write(image, "png", dossier.resolve(nom).toFile());
    }

    @Test
    void lesSortesDePngDesAutresLogicielsSeLisent() throws IOException {
        BufferedImage modele = new BufferedImage(61, 47, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < 47; y++) {
            for (int x = 0; x < 61; x++) {
                int g = x * y % 2 * 255;
                modele.setRGB(x, y, 0xFF000000 | g << 16 | g << 8 | g);
            }
        }
        ImageIO.write(modele, "png", png.toFile());
        for (int sorte : new int[] {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_BYTE_BINARY,
            BufferedImage.TYPE_BYTE_INDEXED, BufferedImage.TYPE_USHORT_GRAY, BufferedImage.TYPE_4BYTE_ABGR}) {
            BufferedImage copie = new BufferedImage(61, 47, sorte);
            for (int k = 0; k < 61 * 47; k++) {
                copie.setRGB(k % 61, k / 61, modele.getRGB(k % 61, k / 61));
            }
            Path autre = dossier.resolve("sorte" + sorte + ".png");
            ImageIO.write(copie, "png", autre.toFile());
            verifierPareilles(comparer(png, autre));
        }
    }

    @Test
    void lImageDesDifferencesEstClaireLaOuEllesSont() throws IOException {
        ecrire("a.png", 0, 0, 0);
        ecrire("b.png", 8, 0, 4);
        Path differences = dossier.resolve("d.png");
        verifierDifferentes(comparer(dossier.resolve("a.png"), dossier.resolve("b.png"), "--image", differences.toString()));
        BufferedImage image = ImageIO.read(differences.toFile());
        assertEquals(0xFF404040, image.getRGB(3, 2));
        assertEquals(0xFF000000, image.getRGB(0, 0));
    }

    @Test
    void ceQuiNeSeComparePasEstUneDemandeFausse() throws IOException {
        ecrire("a.png", 0, 0, 0);
        Path a = dossier.resolve("a.png");
        dessiner("--image", png.toString());
        verifierDemandeFausse("tailles différentes", comparer(a, png));
        verifierDemandeFausse("--comparer ne va pas avec --taille", comparer(a, SCENE, "--taille", "7x5"));
        verifierDemandeFausse("fichier introuvable", comparer(dossier.resolve("absent.png"), SCENE));
        verifierDemandeFausse("c'est un dossier", comparer(Files.createDirectory(dossier.resolve("dossier.png")), SCENE));
        verifierDemandeFausse("--comparer", comparer(SCENE, a));
        verifierDemandeFausse("--tolerance", comparer(a, a, "--tolerance", "-1"));
        verifierDemandeFausse("--tolerance", Essai.executer("--tolerance", "1", SCENE));
        verifierDemandeFausse("aucune scène à dessiner", Essai.executer("--comparer", a.toString()));
        verifierDemandeFausse("une des images comparées", comparer(a, a, "--image", a.toString()));
        byte[] octets = Files.readAllBytes(a);
        Path coupe = dossier.resolve("coupe.png");
        for (int n = 0; n < octets.length; n++) {
            Files.write(coupe, Arrays.copyOf(octets, n));
            Essai e = comparer(coupe, a);
            // le dernier bloc et les contrôles, 24 octets au plus, ne disent rien des pixels
            if (n < octets.length - 24 || e.code != 0) {
                verifierDemandeFausse("image illisible", e);
            }
        }
    }

    @Test
    void uneImageDUnAutreFormatOuUneTailleImpossibleSontRefusees() throws IOException {
        Path autre = dossier.resolve("b.png");
        ImageIO.write(new BufferedImage(7, 5, BufferedImage.TYPE_INT_RGB), "jpg", autre.toFile());
        verifierDemandeFausse("ce n'est pas un PNG", comparer(autre, autre));
        ecrire("a.png", 0, 0, 0);
        byte[] octets = Files.readAllBytes(dossier.resolve("a.png"));
        for (int[] taille : new int[][] {{Integer.MAX_VALUE, Integer.MAX_VALUE}, {-7, -5}, {0, 5}}) {
            ByteBuffer.wrap(octets).putInt(16, taille[0]).putInt(20, taille[1]);
            Files.write(autre, octets);
            verifierDemandeFausse("coupé ou abîmé", comparer(autre, autre));
        }
    }

    @Test
    void unNombreQuiNEnEstPasUnNeSeComparePas() throws IOException {
        byte[] entete = "PF\n1 1\n-1.0\n".getBytes("US-ASCII");
        byte[] image = Arrays.copyOf(entete, entete.length + 12);
        image[image.length - 1] = 0x7F;
        image[image.length - 2] = (byte) 0xC0;
        Files.write(pfm, image);
        verifierDemandeFausse("NaN", comparer(pfm, pfm));
        image[image.length - 2] = (byte) 0x80;
        Files.write(pfm, image);
        verifierDemandeFausse("infini", comparer(pfm, pfm));
    }

    private static void verifierDemandeFausse(String mot, Essai e) {
        assertEquals(2, e.code, e.toString());
        assertEquals("", e.sortie);
        assertTrue(e.erreur.startsWith("lancer : ") && e.erreur.contains(mot) && e.erreur.trim().indexOf('\n') < 0, e.erreur);
    }
}
