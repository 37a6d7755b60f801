package lancer.correction.jugement;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.Base64;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.apache.commons.io.function.Uncheck;

/** Une image, en couleurs non limitées. */
public final class Image {

    private static final double PRES = 1e-6;
    /** Écart, en niveaux, au-delà duquel un pixel est faux. */
    private static final int FAUX = 2;
    /** Part de pixels faux que les arrondis, au bord des sphères et des ombres, peuvent causer. */
    private static final double PART_PERMISE = 0.005;

    public final int largeur;
    public final int hauteur;
    private final float[] rvb;

    /**
     * @param octets réponse de la sonde : les couleurs, en nombres de 32 bits
     * @throws Dialogue.Echec si la réponse n'est pas une image
     */
    Image(int largeur, int hauteur, byte[] octets) {
        this(largeur, hauteur);
        try {
            ByteBuffer.wrap(octets).asFloatBuffer().get(rvb);
        } catch (BufferUnderflowException e) {
            throw new Dialogue.Echec("réponse incompréhensible au lieu d'une image");
        }
    }

    private Image(int largeur, int hauteur) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        rvb = new float[largeur * hauteur * 3];
    }

    /** L'image que {@link #png} a écrite en entier : ses couleurs y ont un octet par composante. */
    static Image lire(String png) {
        BufferedImage lue = Uncheck.get(() -> ImageIO.read(new ByteArrayInputStream(Base64.getDecoder().decode(png))));
        Image image = new Image(lue.getWidth(), lue.getHeight());
        for (int k = 0; k < image.rvb.length; k++) {
            image.rvb[k] = (lue.getRGB(k / 3 % image.largeur, k / 3 / image.largeur) >> 16 - 8 * (k % 3) & 255) / 255f;
        }
        return image;
    }

    /** Un PNG en base 64. @param reduction un pixel sur ce nombre est montré, dans chaque sens */
    public String png(int reduction) {
        BufferedImage image = new BufferedImage(largeur / reduction, hauteur / reduction, BufferedImage.TYPE_INT_RGB);
        IntStream.range(0, image.getWidth()).forEach(x -> IntStream.range(0, image.getHeight()).forEach(y ->
                image.setRGB(x, y, code(reduction * x, reduction * y))));
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        Uncheck.run(() -> ImageIO.write(image, "png", octets));
        return Base64.getEncoder().encodeToString(octets.toByteArray());
    }

    /** Une composante limitée à [0, 1], en niveaux de 1/255 ; 0 si ce n'est pas un nombre. */
    private double niveau(int k) {
        return rvb[k] > 0 ? 255 * Math.min(1, rvb[k]) : 0;
    }

    /** Plus grande différence d'une composante entre deux pixels, en niveaux. */
    double ecart(Image autre, int pixel) {
        return IntStream.range(3 * pixel, 3 * pixel + 3).mapToDouble(k -> Math.abs(niveau(k) - autre.niveau(k))).max().getAsDouble();
    }

    /** Différence des deux images, multipliée par quatre. */
    public Image difference(Image autre) {
        Image difference = new Image(largeur, hauteur);
        for (int k = 0; k < rvb.length; k++) {
            difference.rvb[k] = 4 * Math.abs(Math.round(niveau(k)) - Math.round(autre.niveau(k))) / 255f;
        }
        return difference;
    }

    private long faux(Image autre) {
        return IntStream.range(0, pixels()).filter(p -> ecart(autre, p) > FAUX).count();
    }

    /** Dit si les images sont les mêmes, aux arrondis près. */
    boolean pareille(Image autre) {
        return faux(autre) <= PART_PERMISE * pixels();
    }

    /** « 1 pixel faux sur 4800, de plus de 2 niveaux », « 12 pixels faux… ». */
    String combien(Image autre) {
        long faux = faux(autre);
        return faux + (faux > 1 ? " pixels faux" : " pixel faux") + " sur " + pixels() + ", de plus de " + FAUX + " niveaux";
    }

    /** Nombre de composantes égales dans les deux images, aux arrondis près. */
    long pareilles(Image autre) {
        return IntStream.range(0, rvb.length).filter(k -> Math.abs(rvb[k] - autre.rvb[k]) < PRES).count();
    }

    int pixels() {
        return largeur * hauteur;
    }

    /** Le code du pixel pour l'écran. */
    int code(int x, int y) {
        int code = 0;
        for (int k = 0; k < 3; k++) {
            code = code << 8 | (int) Math.round(niveau(3 * (y * largeur + x) + k));
        }
        return code;
    }
}
