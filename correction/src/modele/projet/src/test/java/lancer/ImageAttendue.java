package lancer;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

/**
 * L'image que l'on attend à une étape, et celle que dessine le programme. Elles ne décident d'aucune note. Ce fichier est
 * donné : il n'y a rien à y changer.
 */
final class ImageAttendue {

    private static final List<String> EXTENSIONS = Arrays.asList("brume", "antialias", "blinn");

    /** La règle de la correction : un pixel faux l'est de plus de 2 niveaux, une image fausse de plus d'un pixel sur 200. */
    private static final int FAUX = 2;
    private static final int PERMIS = 200;

    private static final int REFLETS = 5;
    private static final int SECONDES = 20;

    private static final Path DESSINEE = Paths.get("target", "image.png");
    private static final Path DIFFERENCES = Paths.get("target", "differences.png");

    private final String etape;
    private final BufferedImage attendue;
    private final String scene;

    /** Vrai si trop de pixels ne sont pas ceux que l'on attend. */
    boolean fausse;
    private boolean tracerFautive;

    private ImageAttendue(String etape, URL image) throws IOException, URISyntaxException {
        this.etape = etape;
        attendue = ImageIO.read(image);
        String nom = etape.equals("lambert") ? "diffus" : "scene1";
        scene = Paths.get(ImageAttendue.class.getResource("/attendues/" + nom + ".ini").toURI()).toString();
    }

    /** L'image de cette étape ; {@code null} si elle n'en a pas, ou si ce projet est la copie d'une extension. */
    static ImageAttendue de(String etape) {
        URL image = ImageAttendue.class.getResource("/attendues/" + etape + ".png");
        try {
            return image == null || extension() != null ? null : new ImageAttendue(etape, image);
        } catch (IOException | URISyntaxException e) {
            return null;
        }
    }

    /** L'extension dont ce projet est la copie, d'après le nom de son dossier ; {@code null} s'il n'en est pas une. */
    static String extension() {
        String dossier = String.valueOf(Paths.get("").toAbsolutePath().getFileName());
        return EXTENSIONS.contains(dossier) ? dossier : null;
    }

    /** Dessine, écrit dans {@code target} l'image et les différences, et dit en une phrase combien de pixels sont faux. */
    String comparer() {
        FutureTask<BufferedImage> dessin = new FutureTask<>(this::dessiner);
        Thread fil = new Thread(dessin);
        fil.setDaemon(true);
        PrintStream sortie = System.out;
        System.setOut(new PrintStream(new ByteArrayOutputStream()));
        fausse = true;
        try {
            fil.start();
            return comparer(dessin.get(SECONDES, TimeUnit.SECONDS));
        } catch (TimeoutException | InterruptedException e) {
            return "L'image de cette étape n'est pas dessinée en " + SECONDES + " secondes.";
        } catch (ExecutionException e) {
            return "Le dessin de l'image échoue : " + e.getCause() + Arrays.stream(e.getCause().getStackTrace())
                    .filter(Causes::deLEtudiant).findFirst().map(a -> ", " + a.getFileName() + ":" + a.getLineNumber()).orElse("");
        } catch (IOException e) {
            return "L'image de cette étape ne peut être écrite : " + e.getMessage();
        } finally {
            System.setOut(sortie);
        }
    }

    private String comparer(BufferedImage image) throws IOException {
        BufferedImage differences = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_RGB);
        for (int p = 0; p < image.getWidth() * image.getHeight(); p++) {
            int x = p % image.getWidth();
            int y = p / image.getWidth();
            int[] ecarts = ecarts(image.getRGB(x, y), attendue.getRGB(x, y)).map(e -> Math.min(255, 4 * e)).toArray();
            differences.setRGB(x, y, ecarts[0] << 16 | ecarts[1] << 8 | ecarts[2]);
        }
        Files.createDirectories(DESSINEE.getParent());
        ImageIO.write(image, "png", DESSINEE.toFile());
        ImageIO.write(differences, "png", DIFFERENCES.toFile());
        int faux = faux(image);
        fausse = fausse(image);
        return DESSINEE + ", comparée à src/test/resources/attendues/" + etape + ".png : " + faux + (faux > 1 ? " pixels faux" : " pixel faux")
                + " sur " + pixels() + (fausse ? " ; les différences : " + DIFFERENCES : ", c'est la même")
                + (tracerFautive ? " ; getCouleurPixel est juste, mais TracerImage dessine autre chose : Lancer.java" : "");
    }

    /** Par TracerImage ; ou bien, si getCouleurPixel ajoute lui-même le demi-pixel, pixel par pixel. */
    private BufferedImage dessiner() throws Exception {
        BufferedImage image = tracer(scene, attendue.getWidth(), attendue.getHeight());
        if (!fausse(image)) {
            return image;
        }
        BufferedImage auCoin = pixelParPixel(0);
        tracerFautive = !fausse(pixelParPixel(0.5));
        return fausse(auCoin) ? image : auCoin;
    }

    private BufferedImage pixelParPixel(double decalage) throws Exception {
        BufferedImage image = new BufferedImage(attendue.getWidth(), attendue.getHeight(), BufferedImage.TYPE_INT_RGB);
        Lancer lancer = new Lancer(new Scene(scene), new Camera(image.getWidth(), image.getHeight()));
        for (int p = 0; p < pixels(); p++) {
            int x = p % image.getWidth();
            int y = p / image.getWidth();
            image.setRGB(x, y, lancer.getCouleurPixel(x + decalage, y + decalage, REFLETS).getCode());
        }
        return image;
    }

    /** Ce que dessine TracerImage. */
    static BufferedImage tracer(String scene, int largeur, int hauteur) throws Exception {
        BufferedImage image = new BufferedImage(largeur, hauteur, BufferedImage.TYPE_INT_RGB);
        new Lancer(new Scene(scene), new Camera(largeur, hauteur)).TracerImage(new Toile() {
            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                image.setRGB(xe, ye, coul.getCode());
            }

            @Override
            public void avancer(double part) {
                // personne ne regarde
            }
        }, largeur, hauteur, REFLETS);
        return image;
    }

    private int pixels() {
        return attendue.getWidth() * attendue.getHeight();
    }

    private boolean fausse(BufferedImage image) {
        return faux(image) > pixels() / PERMIS;
    }

    private int faux(BufferedImage image) {
        return (int) IntStream.range(0, pixels()).filter(p -> ecarts(image.getRGB(p % image.getWidth(), p / image.getWidth()),
                attendue.getRGB(p % image.getWidth(), p / image.getWidth())).anyMatch(e -> e > FAUX)).count();
    }

    /** Les écarts des composantes de deux codes. */
    private static IntStream ecarts(int a, int b) {
        return Stream.of(16, 8, 0).mapToInt(d -> Math.abs((a >> d & 255) - (b >> d & 255)));
    }
}
