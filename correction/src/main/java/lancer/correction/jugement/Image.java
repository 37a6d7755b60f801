package lancer.correction.jugement;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.Base64;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.csv.CSVRecord;

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
     * @param texte réponse de la sonde : les couleurs, en nombres de 32 bits, en base 64
     * @throws Dialogue.Echec si la réponse n'est pas une image
     */
    Image(int largeur, int hauteur, String texte) {
        this(largeur, hauteur);
        try {
            ByteBuffer.wrap(Base64.getDecoder().decode(texte)).asFloatBuffer().get(rvb);
        } catch (IllegalArgumentException | BufferUnderflowException e) {
            throw new Dialogue.Echec("réponse incompréhensible au lieu d'une image");
        }
    }

    private Image(int largeur, int hauteur) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        rvb = new float[largeur * hauteur * 3];
    }

    /** L'image qu'a écrite {@link #ligne}. */
    Image(CSVRecord ligne) {
        this(Integer.parseInt(ligne.get(2)), Integer.parseInt(ligne.get(3)));
        byte[] octets = Base64.getDecoder().decode(ligne.get(4));
        for (int k = 0; k < rvb.length; k++) {
            rvb[k] = (octets[k] & 255) / 255f;
        }
    }

    /** Ligne d'un fichier de résultats : les couleurs y ont un octet par composante. */
    List<?> ligne(String nom) {
        byte[] octets = new byte[rvb.length];
        for (int k = 0; k < rvb.length; k++) {
            octets[k] = (byte) Math.round(niveau(k));
        }
        return List.of("image", nom, largeur, hauteur, Base64.getEncoder().encodeToString(octets));
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
    public int code(int x, int y) {
        int code = 0;
        for (int k = 0; k < 3; k++) {
            code = code << 8 | (int) Math.round(niveau(3 * (y * largeur + x) + k));
        }
        return code;
    }
}
