package lancer.auto;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * L'erreur quadratique moyenne d'une image, en niveaux, estimée sur des pixels tirés dans deux strates (W. G. Cochran,
 * <i>Sampling Techniques</i>, 1977, ch. 5) : ceux dont les voisins diffèrent, et le reste. Immuable.
 */
public final class Mesure {

    /** Quantile à 97,5 % de la loi normale ; de ce que l'on n'a pas vu, le plus grand nombre attendu, à 97,5 %. */
    private static final double NORMALE = 1.96;
    private static final double ZERO_VU = 3.69;

    /** L'erreur ; la plus grande de ses distances aux bornes de son intervalle de confiance à 95 %. */
    public final double erreur;
    public final double incertitude;
    /** Vrai si aucun pixel tiré ne s'écarte de ses références : rien ne se sait alors des autres. */
    public final boolean rienVu;
    private final int[] tailles;
    private final double[][] carres;
    private double carre;
    private double variance;
    private double varianceDesManques;

    /**
     * @param tailles nombre de pixels du reste, puis des bords
     * @param carres pour chaque pixel tiré de ces deux strates, une estimation sans biais du carré de son erreur, en
     *        niveaux²
     */
    Mesure(int[] tailles, double[][] carres, boolean rienVu) {
        this.tailles = tailles;
        this.carres = carres;
        this.rienVu = rienVu;
        // un écart aussi grand que ceux des bords a pu manquer plusieurs fois dans le reste
        ajouter(0, moyenne(carres[1]));
        ajouter(1, 0);
        erreur = plus(0);
        incertitude = Math.max(erreur - plus(-NORMALE), plus(NORMALE) - erreur);
    }

    private static double moyenne(double[] carres) {
        return Arrays.stream(carres).average().orElse(0);
    }

    /** @param voisin un écart qui a pu manquer plusieurs fois, comme le plus grand vu */
    private void ajouter(int strate, double voisin) {
        double[] siens = carres[strate];
        double part = (double) tailles[strate] / Arrays.stream(tailles).sum() / Math.max(1, siens.length);
        double moyenne = moyenne(siens);
        carre += part * Arrays.stream(siens).sum();
        variance += part * part * Arrays.stream(siens).map(c -> (c - moyenne) * (c - moyenne)).sum();
        double grand = Math.max(voisin, Arrays.stream(siens).max().orElse(0));
        double manque = part * ZERO_VU / NORMALE * Math.max(0, grand);
        varianceDesManques += manque * manque;
    }

    /** L'erreur, si son carré s'écarte de ce nombre d'écarts types. */
    double plus(double ecartsTypes) {
        // ce qui manque ne peut qu'augmenter l'erreur
        double ecart = Math.sqrt(variance + (ecartsTypes > 0 ? varianceDesManques : 0));
        return Math.sqrt(Math.max(0, carre + ecartsTypes * ecart));
    }

    /**
     * De combien l'autre réglage diminue le carré de l'erreur, à tant d'écarts types près : d'une différence, pixel par
     * pixel, le hasard des références, le même pour les deux, disparaît.
     */
    double gain(Mesure autre, double ecartsTypes) {
        double[][] gains = IntStream.range(0, 2).mapToObj(s -> IntStream.range(0, carres[s].length)
                .mapToDouble(k -> carres[s][k] - autre.carres[s][k]).toArray()).toArray(double[][]::new);
        Mesure gain = new Mesure(tailles, gains, false);
        return gain.carre + ecartsTypes * Math.sqrt(gain.variance);
    }

    /** L'erreur et son intervalle ; ou, là où rien n'est vu, ce qui peut manquer. */
    public String enMots() {
        if (!rienVu) {
            return String.format(Locale.ROOT, "erreur de %.2f ± %.2f", erreur, incertitude);
        }
        int tires = carres[0].length + carres[1].length;
        return "aucun écart sur " + tires + " pixels" + (tires == tailles[0] + tailles[1] ? ""
                : " ; un détail de moins d'un pixel sur " + tires / 3 + " peut manquer");
    }
}
