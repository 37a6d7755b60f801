package lancer.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import lancer.systeme.Ecriture;

/** Le format PFM : les couleurs non limitées, en nombres de 32 bits petit-boutistes, du bas de l'image vers le haut. */
public final class FichierPfm implements Ecriture.Format<ImageMemoire> {

    /** @param image une image qui a gardé ses couleurs non limitées */
    @Override
    public void ecrire(ImageMemoire image, OutputStream sortie) throws IOException {
        int largeur = image.largeur;
        // une échelle négative annonce des octets petit-boutistes
        sortie.write(("PF\n" + largeur + " " + image.hauteur + "\n-1.0\n").getBytes(StandardCharsets.US_ASCII));
        ByteBuffer ligne = ByteBuffer.allocate(3 * largeur * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        for (int j = image.hauteur - 1; j >= 0; j--) {
            ligne.asFloatBuffer().put(image.lineaire, 3 * j * largeur, 3 * largeur);
            sortie.write(ligne.array());
        }
    }
}
