package lancer.mesures.juge;

import java.util.Arrays;
import java.util.stream.IntStream;
import lancer.mesures.ImageLineaire;

/**
 * Deux images de la même scène, pixel par pixel. Les composantes sont la lumière limitée à [0, 1] ; les écarts se comptent en pas
 * d'un écran, 1/255.
 */
final class Accord {

    private static final double PAS_8 = 1 / 255.0;
    private static final double PAS_16 = 1 / 65535.0;

    /** Un pixel sur tant peut s'écarter de plus d'un pas de 16 bits : sur un bord, ou après cinq reflets entre petites boules. */
    private static final int UN_SUR = 1000;

    /** Pixels dont une composante s'écarte de plus d'un pas de 8 bits, de 16 bits. */
    final int auDela8;
    final int auDela16;

    /** Le plus grand écart d'une composante, en pas de 8 bits, et le rang de son pixel. */
    final double pire;
    final int pirePixel;

    /** La racine de l'écart quadratique moyen des composantes, en pas de 8 bits. */
    final double moyen;

    private final int pixels;

    Accord(ImageLineaire nous, ImageLineaire lui) {
        double[] a = nous.getComposantes();
        double[] b = lui.getComposantes();
        pixels = a.length / 3;
        double[] ecarts = IntStream.range(0, a.length).mapToDouble(c -> Math.abs(limite(a[c]) - limite(b[c]))).toArray();
        double[] pires = IntStream.range(0, a.length).filter(c -> c % 3 == 0)
                .mapToDouble(c -> Math.max(ecarts[c], Math.max(ecarts[c + 1], ecarts[c + 2]))).toArray();
        auDela8 = (int) Arrays.stream(pires).filter(e -> e > PAS_8).count();
        auDela16 = (int) Arrays.stream(pires).filter(e -> e > PAS_16).count();
        pirePixel = IntStream.range(0, pixels).reduce(0, (p, q) -> pires[q] > pires[p] ? q : p);
        pire = pires[pirePixel] / PAS_8;
        moyen = Math.sqrt(Arrays.stream(ecarts).map(e -> e * e).average().orElse(0)) / PAS_8;
    }

    /** Vrai si aucun pixel ne s'écarte d'un niveau d'écran, ni plus d'un sur mille d'un niveau de 16 bits. */
    boolean estLa() {
        return auDela8 == 0 && (long) auDela16 * UN_SUR <= pixels;
    }

    private static double limite(double composante) {
        return Math.max(0, Math.min(1, composante));
    }
}
