package lancer.mesures.juge;

import java.awt.image.Raster;
import java.util.ArrayList;
import java.util.List;

/**
 * Deux images de la même scène, pixel par pixel. Les composantes sont la lumière limitée à [0, 1] ; les écarts se comptent en pas
 * d'un écran, 1/255.
 */
final class Accord {

    /** Niveaux d'un écran, et de l'image du juge. */
    static final double PAS_8 = 1 / 255.0;
    static final double PAS_16 = 1 / 65535.0;

    private final int largeur;
    private final float[] nous;
    private final Raster[] lui;

    /** Pixels dont une composante s'écarte de plus d'un pas de 8 bits. */
    final int auDela8;

    /** Rangs, ligne par ligne, des pixels dont une composante s'écarte de plus d'un pas de 16 bits. */
    final List<Integer> auDela16 = new ArrayList<>();

    /** Le plus grand écart d'une composante, en pas de 8 bits. */
    final double pire;

    /** La racine de l'écart quadratique moyen des composantes, en pas de 8 bits. */
    final double moyen;

    /**
     * @param nous nos couleurs linéaires, trois par pixel, la ligne du haut d'abord
     * @param lui les images du juge ; de trois, chacune ne vaut que pour la composante de son rang
     */
    Accord(int largeur, int hauteur, float[] nous, Raster... lui) {
        this.largeur = largeur;
        this.nous = nous;
        this.lui = lui;
        int plusDUnPas = 0;
        double plusGrand = 0;
        double carres = 0;
        for (int k = 0; k < largeur * hauteur; k++) {
            double ecart = 0;
            for (Composante c : Composante.values()) {
                double e = Math.abs(nous(k, c) - juge(k, c));
                ecart = Math.max(ecart, e);
                carres += e * e;
            }
            plusGrand = Math.max(plusGrand, ecart);
            if (ecart > PAS_16) {
                auDela16.add(k);
            }
            if (ecart > PAS_8) {
                plusDUnPas++;
            }
        }
        auDela8 = plusDUnPas;
        pire = plusGrand / PAS_8;
        moyen = Math.sqrt(carres / (3.0 * largeur * hauteur)) / PAS_8;
    }

    /** Notre pixel de rang {@code k}, limité à [0, 1]. */
    double nous(int k, Composante c) {
        return limite(nous[3 * k + c.ordinal()]);
    }

    /** Celui du juge. */
    double juge(int k, Composante c) {
        Raster image = lui[lui.length == 1 ? 0 : c.ordinal()];
        return image.getSample(k % largeur, k / largeur, c.ordinal()) * PAS_16;
    }

    static double limite(double composante) {
        return Math.max(0, Math.min(1, composante));
    }
}
