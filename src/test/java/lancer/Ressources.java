package lancer;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import lancer.contrat.Toile;

/** Les fichiers des tests, et une image PFM lue ou dessinée. */
final class Ressources {

    private Ressources() {
    }

    /** Le chemin d'un fichier de {@code src/test/resources}. */
    static String chemin(String nom) {
        try {
            return Paths.get(Ressources.class.getResource("/" + nom).toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    static InputStream ouvrir(String nom) {
        return Ressources.class.getResourceAsStream("/" + nom);
    }

    /** Une image en couleurs non limitées : trois flottants par pixel, ligne par ligne depuis le haut. */
    static final class Image implements Toile {

        final int largeur;
        final int hauteur;
        final float[] composantes;

        Image(int largeur, int hauteur) {
            this.largeur = largeur;
            this.hauteur = hauteur;
            this.composantes = new float[3 * largeur * hauteur];
        }

        @Override
        public void drawPixel(Couleur coul, int xe, int ye) {
            int k = 3 * (ye * largeur + xe);
            composantes[k] = (float) coul.r;
            composantes[k + 1] = (float) coul.v;
            composantes[k + 2] = (float) coul.b;
        }

        /** La plus grande différence avec une autre image, composante par composante ; +∞ si un nombre n'est pas fini. */
        double ecart(Image autre) {
            double pire = largeur == autre.largeur && hauteur == autre.hauteur ? 0 : Double.POSITIVE_INFINITY;
            for (int k = 0; k < composantes.length; k++) {
                double d = Math.abs(composantes[k] - autre.composantes[k]);
                pire = d <= pire ? pire : Double.isNaN(d) ? Double.POSITIVE_INFINITY : d;
            }
            return pire;
        }
    }

    /** Un fichier PFM de {@code src/test/resources}. */
    static Image pfm(String nom) {
        return pfm(Paths.get(chemin(nom)));
    }

    static Image pfm(Path nom) {
        try (DataInputStream entree = new DataInputStream(new BufferedInputStream(Files.newInputStream(nom)))) {
            if (!ligne(entree).equals("PF")) {
                throw new IOException("pas un PFM en couleurs : " + nom);
            }
            String[] taille = ligne(entree).split(" ");
            Image image = new Image(Integer.parseInt(taille[0]), Integer.parseInt(taille[1]));
            if (Double.parseDouble(ligne(entree)) >= 0) {
                throw new IOException("gros-boutiste : " + nom);
            }
            byte[] octets = new byte[4 * 3 * image.largeur];
            for (int j = image.hauteur - 1; j >= 0; j--) {
                entree.readFully(octets);
                ByteBuffer.wrap(octets).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer()
                        .get(image.composantes, 3 * j * image.largeur, 3 * image.largeur);
            }
            return image;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String ligne(DataInputStream entree) throws IOException {
        StringBuilder s = new StringBuilder();
        for (int c = entree.readUnsignedByte(); c != '\n'; c = entree.readUnsignedByte()) {
            s.append((char) c);
        }
        return s.toString();
    }
}
