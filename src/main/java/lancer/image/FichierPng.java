package lancer.image;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import lancer.systeme.Ecriture;

/** Le format PNG (ISO/IEC 15948), 8 bits par composante, sans ImageIO : charger AWT dure plus que dessiner. */
public final class FichierPng implements Ecriture.Format<ImageMemoire> {

    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    private static final byte HUIT_BITS = 8;
    private static final byte ROUGE_VERT_BLEU = 2;
    private static final byte FILTRE_GAUCHE = 1;

    /** Taille d'un bloc de données compressées, en octets. */
    private static final int BLOC = 1 << 16;

    @Override
    public void ecrire(ImageMemoire image, OutputStream fichier) throws IOException {
        DataOutputStream sortie = new DataOutputStream(fichier);
        sortie.write(SIGNATURE);
        ByteBuffer entete = ByteBuffer.allocate(13).putInt(image.largeur).putInt(image.hauteur)
                .put(HUIT_BITS).put(ROUGE_VERT_BLEU);
        bloc(sortie, "IHDR", entete.array(), entete.capacity());
        pixels(sortie, image);
        bloc(sortie, "IEND", new byte[0], 0);
    }

    private static void pixels(DataOutputStream sortie, ImageMemoire image) throws IOException {
        Deflater compression = new Deflater(Deflater.BEST_SPEED);
        try {
            int largeur = image.largeur;
            byte[] ligne = new byte[1 + 3 * largeur];
            ligne[0] = FILTRE_GAUCHE;
            byte[] tampon = new byte[BLOC];
            int remplis = 0;
            for (int j = 0; j < image.hauteur; j++) {
                filtrer(image.codes, j * largeur, ligne);
                compression.setInput(ligne);
                if (j == image.hauteur - 1) {
                    compression.finish();
                }
                while (!compression.needsInput() || j == image.hauteur - 1 && !compression.finished()) {
                    remplis += compression.deflate(tampon, remplis, BLOC - remplis);
                    if (remplis == BLOC) {
                        bloc(sortie, "IDAT", tampon, remplis);
                        remplis = 0;
                    }
                }
            }
            bloc(sortie, "IDAT", tampon, remplis);
        } finally {
            compression.end();
        }
    }

    /** Remplace chaque octet par sa différence avec celui du pixel de gauche : un dégradé se comprime mieux. */
    private static void filtrer(int[] codes, int debut, byte[] ligne) {
        int gauche = 0;
        for (int i = debut, k = 1; k < ligne.length; i++) {
            int code = codes[i];
            ligne[k++] = (byte) ((code >> 16) - (gauche >> 16));
            ligne[k++] = (byte) ((code >> 8) - (gauche >> 8));
            ligne[k++] = (byte) (code - gauche);
            gauche = code;
        }
    }

    private static void bloc(DataOutputStream sortie, String type, byte[] donnees, int longueur) throws IOException {
        byte[] nom = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 controle = new CRC32();
        controle.update(nom);
        controle.update(donnees, 0, longueur);
        sortie.writeInt(longueur);
        sortie.write(nom);
        sortie.write(donnees, 0, longueur);
        sortie.writeInt((int) controle.getValue());
    }
}
