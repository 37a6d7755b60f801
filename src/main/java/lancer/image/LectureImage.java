package lancer.image;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOError;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Paths;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import lancer.Couleur;
import lancer.systeme.Echec;
import lancer.systeme.ErreurSysteme;
import lancer.texte.Texte;

/** Lit un PNG ou un PFM à comparer. Les échantillons d'un PNG sont pris tels quels, sans gamma ni transparence. */
public final class LectureImage {

    /** Sorte, largeur, hauteur, échelle, puis un seul blanc avant les données. */
    private static final Pattern ENTETE_PFM =
            Pattern.compile("P([Ff])\\s+(\\d{1,7})\\s+(\\d{1,7})\\s+([-+]?\\d+\\.?\\d*(?:[eE][-+]?\\d+)?)\\s");

    private LectureImage() {
    }

    /** L'image, sans couleurs non limitées si elle n'a que 8 bits. @throws Echec si ce n'est ni un PNG, ni un PFM */
    public static ImageMemoire lire(String nom) {
        try {
            byte[] octets = Files.readAllBytes(Paths.get(nom));
            return Texte.minuscules(nom).endsWith(".png") ? lirePng(octets) : lirePfm(octets);
        } catch (IOException | InvalidPathException | IOError e) {
            throw Echec.demande(Texte.echappe(nom) + " : image illisible : " + ErreurSysteme.raison(e, nom)
                    + ErreurSysteme.horsLangue(nom) + " ; attendu : un PNG ou un PFM");
        }
    }

    private static ImageMemoire lirePng(byte[] octets) throws IOException {
        BufferedImage lue;
        ImageReader lecteur = ImageIO.getImageReadersByFormatName("png").next();
        try {
            lecteur.setInput(new MemoryCacheImageInputStream(new ByteArrayInputStream(octets)));
            lue = lecteur.read(0);
        } catch (IOException | RuntimeException e) {
            if (e.getCause() instanceof OutOfMemoryError) {
                throw (OutOfMemoryError) e.getCause();
            }
            throw new IOException("ce n'est pas un PNG, ou il est coupé ou abîmé");
        }
        Raster echantillons = lue.getColorModel() instanceof IndexColorModel
                ? ((IndexColorModel) lue.getColorModel()).convertToIntDiscrete(lue.getRaster(), true).getRaster()
                : lue.getRaster();
        int max = (1 << echantillons.getSampleModel().getSampleSize(0)) - 1;
        // une image en gris n'a qu'un échantillon par pixel
        int pas = echantillons.getNumBands() < 3 ? 0 : 1;
        ImageMemoire image = new ImageMemoire(lue.getWidth(), lue.getHeight(), max > 255);
        for (int y = 0; y < lue.getHeight(); y++) {
            for (int x = 0; x < lue.getWidth(); x++) {
                Couleur couleur = new Couleur(echantillons.getSample(x, y, 0), echantillons.getSample(x, y, pas),
                        echantillons.getSample(x, y, 2 * pas));
                image.drawPixel(couleur.div(max), x, y);
            }
        }
        return image;
    }

    private static ImageMemoire lirePfm(byte[] octets) throws IOException {
        Matcher entete = ENTETE_PFM.matcher(
                new String(octets, 0, Math.min(octets.length, 160), StandardCharsets.ISO_8859_1));
        if (!entete.lookingAt()) {
            throw new IOException("l'en-tête n'est pas celui d'un PFM");
        }
        boolean gris = entete.group(1).equals("f");
        int largeur = Integer.parseInt(entete.group(2));
        int hauteur = Integer.parseInt(entete.group(3));
        double echelle = Double.parseDouble(entete.group(4));
        ByteBuffer donnees = ByteBuffer.wrap(octets, entete.end(), octets.length - entete.end())
                .order(echelle < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        long pixels = (long) largeur * hauteur;
        if (pixels == 0 || echelle == 0 || donnees.remaining() != pixels * (gris ? 1 : 3) * Float.BYTES) {
            throw new IOException("trop ou trop peu d'octets (en-tête aux lignes en CRLF ?)");
        }
        ImageMemoire image = new ImageMemoire(largeur, hauteur, true);
        for (int y = hauteur - 1; y >= 0; y--) {
            for (int x = 0; x < largeur; x++) {
                float r = donnees.getFloat();
                Couleur couleur = gris ? new Couleur(r) : new Couleur(r, donnees.getFloat(), donnees.getFloat());
                if (!couleur.estFinie()) {
                    throw new IOException("une couleur n'est pas un nombre fini (NaN ou infini)");
                }
                image.drawPixel(couleur, x, y);
            }
        }
        return image;
    }
}
