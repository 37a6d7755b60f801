package lancer.sortie;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Lit une image PFM, de couleurs ou de gris, de l'un ou l'autre ordre d'octets. */
final class LecturePfm {

    private final byte[] octets;
    private int ici;

    private LecturePfm(byte[] octets) {
        this.octets = octets;
    }

    static ImageLue lire(byte[] octets) throws IOException {
        return new LecturePfm(octets).lire();
    }

    private ImageLue lire() throws IOException {
        String sorte = mot();
        if (!sorte.equals("PF") && !sorte.equals("Pf")) {
            throw new IOException("l'en-tête n'est pas celui d'un PFM");
        }
        int composantes = sorte.equals("PF") ? 3 : 1;
        long largeur;
        long hauteur;
        double echelle;
        try {
            largeur = Integer.parseInt(mot());
            hauteur = Integer.parseInt(mot());
            echelle = Double.parseDouble(mot());
        } catch (NumberFormatException e) {
            throw new IOException("l'en-tête n'est pas celui d'un PFM");
        }
        if (largeur < 1 || hauteur < 1 || largeur * hauteur > Integer.MAX_VALUE / 12 || echelle == 0
                || octets.length - ici != largeur * hauteur * composantes * Float.BYTES) {
            throw new IOException("le nombre d'octets n'est pas celui qu'annonce l'en-tête");
        }
        ByteBuffer donnees = ByteBuffer.wrap(octets, ici, octets.length - ici)
                .order(echelle < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        float[] rvb = new float[(int) (3 * largeur * hauteur)];
        // la ligne du bas est la première
        for (int y = (int) hauteur - 1; y >= 0; y--) {
            for (int k = 0; k < largeur * 3; k++) {
                rvb[(int) (y * largeur * 3) + k] = composantes == 3 || k % 3 == 0 ? donnees.getFloat()
                        : rvb[(int) (y * largeur * 3) + k - 1];
            }
        }
        return new ImageLue((int) largeur, (int) hauteur, rvb, false);
    }

    /** Le mot suivant de l'en-tête, et le seul blanc qui le suit. */
    private String mot() throws IOException {
        int debut = ici;
        while (ici < octets.length && octets[ici] > ' ') {
            ici++;
        }
        if (ici == octets.length || ici == debut || ici - debut > 40) {
            throw new IOException("l'en-tête n'est pas celui d'un PFM");
        }
        return new String(octets, debut, ici++ - debut, StandardCharsets.US_ASCII);
    }
}
