package lancer.sortie;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * Lit une image PNG (ISO/IEC 15948), de 1 à 16 bits, grise, en couleurs ou à palette, transparence laissée ; sans AWT,
 * comme {@link FichierPng} l'écrit. Les images entrelacées sont refusées.
 */
final class LecturePng {

    private static final long SIGNATURE = 0x89504E470D0A1A0AL;
    private static final int PALETTE = 3;
    /** Nombre d'échantillons d'un pixel, selon la sorte de couleur. */
    private static final int[] ECHANTILLONS = {1, 0, 3, 1, 2, 0, 4};

    private int largeur;
    private int hauteur;
    private int bits;
    private int sorte;
    private byte[] palette = {};
    private final ByteArrayOutputStream comprime = new ByteArrayOutputStream();

    private LecturePng() {
    }

    static ImageLue lire(byte[] octets) throws IOException {
        LecturePng lecture = new LecturePng();
        try {
            lecture.blocs(new DataInputStream(new ByteArrayInputStream(octets)));
            return lecture.pixels();
        } catch (EOFException | DataFormatException e) {
            throw new IOException("le PNG est coupé ou abîmé");
        }
    }

    private void blocs(DataInputStream entree) throws IOException {
        if (entree.readLong() != SIGNATURE) {
            throw new IOException("la signature n'est pas celle d'un PNG");
        }
        for (String type = ""; !type.equals("IEND");) {
            int longueur = entree.readInt();
            if (longueur < 0 || longueur > entree.available()) {
                throw new EOFException();
            }
            byte[] bloc = new byte[4 + longueur];
            entree.readFully(bloc);
            CRC32 controle = new CRC32();
            controle.update(bloc);
            if ((int) controle.getValue() != entree.readInt()) {
                throw new EOFException();
            }
            type = new String(bloc, 0, 4, StandardCharsets.US_ASCII);
            bloc(type, new DataInputStream(new ByteArrayInputStream(bloc, 4, longueur)), longueur);
        }
    }

    private void bloc(String type, DataInputStream bloc, int longueur) throws IOException {
        switch (type) {
            case "IHDR":
                largeur = bloc.readInt();
                hauteur = bloc.readInt();
                bits = bloc.readUnsignedByte();
                sorte = bloc.readUnsignedByte();
                bloc.readUnsignedShort();
                if (bloc.readUnsignedByte() != 0) {
                    throw new IOException("les PNG entrelacés ne sont pas lus");
                }
                if (largeur < 1 || hauteur < 1 || (long) largeur * hauteur > Integer.MAX_VALUE / 12
                        || Integer.bitCount(bits) != 1 || bits > 16
                        || sorte >= ECHANTILLONS.length || ECHANTILLONS[sorte] == 0) {
                    throw new EOFException();
                }
                break;
            case "PLTE":
                palette = new byte[longueur];
                bloc.readFully(palette);
                break;
            case "IDAT":
                byte[] donnees = new byte[longueur];
                bloc.readFully(donnees);
                comprime.write(donnees);
                break;
            default:
                // le reste ne change pas les couleurs
        }
    }

    private ImageLue pixels() throws DataFormatException, IOException {
        if (largeur == 0) {
            throw new EOFException();
        }
        int parPixel = ECHANTILLONS[sorte];
        int pas = Math.max(1, parPixel * bits / 8);
        byte[] ligne = new byte[pas + (int) (((long) largeur * parPixel * bits + 7) / 8)];
        byte[] dessus = new byte[ligne.length];
        float[] rvb = new float[3 * largeur * hauteur];
        Inflater deplie = new Inflater();
        try {
            deplie.setInput(comprime.toByteArray());
            byte[] filtre = new byte[1];
            for (int y = 0; y < hauteur; y++) {
                remplir(deplie, filtre, 0);
                remplir(deplie, ligne, pas);
                defiltrer(filtre[0], ligne, dessus, pas);
                for (int x = 0; x < largeur; x++) {
                    pixel(ligne, pas, x * parPixel, rvb, 3 * (y * largeur + x));
                }
                byte[] avant = dessus;
                dessus = ligne;
                ligne = avant;
            }
        } finally {
            deplie.end();
        }
        return new ImageLue(largeur, hauteur, rvb, bits <= 8);
    }

    private static void remplir(Inflater deplie, byte[] octets, int debut) throws DataFormatException, EOFException {
        int k = debut;
        while (k < octets.length) {
            int n = deplie.inflate(octets, k, octets.length - k);
            if (n == 0) {
                throw new EOFException();
            }
            k += n;
        }
    }

    /** @param pas octets d'un pixel : autant de zéros précèdent chaque ligne */
    private static void defiltrer(int filtre, byte[] ligne, byte[] dessus, int pas) throws EOFException {
        for (int k = pas; k < ligne.length; k++) {
            int a = ligne[k - pas] & 255;
            int b = dessus[k] & 255;
            int c = dessus[k - pas] & 255;
            switch (filtre) {
                case 0:
                    return;
                case 1:
                    ligne[k] += (byte) a;
                    break;
                case 2:
                    ligne[k] += (byte) b;
                    break;
                case 3:
                    ligne[k] += (byte) ((a + b) / 2);
                    break;
                case 4:
                    ligne[k] += (byte) paeth(a, b, c);
                    break;
                default:
                    throw new EOFException();
            }
        }
    }

    private static int paeth(int a, int b, int c) {
        int p = a + b - c;
        int pa = Math.abs(p - a);
        int pb = Math.abs(p - b);
        int pc = Math.abs(p - c);
        return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
    }

    private void pixel(byte[] ligne, int debut, int premier, float[] rvb, int ou) throws EOFException {
        for (int k = 0; k < 3; k++) {
            if (sorte == PALETTE) {
                int rang = 3 * echantillon(ligne, debut, premier) + k;
                if (rang >= palette.length) {
                    throw new EOFException();
                }
                rvb[ou + k] = (palette[rang] & 255) / 255f;
            } else {
                rvb[ou + k] = echantillon(ligne, debut, premier
                        + (ECHANTILLONS[sorte] > 2 ? k : 0)) / (float) ((1 << bits) - 1);
            }
        }
    }

    private int echantillon(byte[] ligne, int debut, int rang) {
        if (bits == 16) {
            return (ligne[debut + 2 * rang] & 255) << 8 | ligne[debut + 2 * rang + 1] & 255;
        }
        int bit = rang * bits;
        return (ligne[debut + bit / 8] & 255) >> 8 - bits - bit % 8 & (1 << bits) - 1;
    }
}
