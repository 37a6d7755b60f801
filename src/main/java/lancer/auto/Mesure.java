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
    private final boolean[] bords;
    private final double[] carres;
    private double carre;
    private double variance;
    private double varianceDesManques;

    /**
     * @param tailles nombre de pixels du reste, puis des bords
     * @param bords pour chaque pixel tiré, vrai s'il est d'un bord
     * @param carres une estimation sans biais du carré de son erreur, en niveaux²
     */
    Mesure(int[] tailles, boolean[] bords, double[] carres, boolean rienVu) {
        this.tailles = tailles;
        this.bords = bords;
        this.carres = carres;
        this.rienVu = rienVu;
        ajouter(false);
        ajouter(true);
        erreur = plus(0);
        incertitude = Math.max(erreur - plus(-NORMALE), plus(NORMALE) - erreur);
    }

    private double[] strate(boolean bord) {
        return IntStream.range(0, carres.length).filter(k -> bords[k] == bord).mapToDouble(k -> carres[k]).toArray();
    }

    private void ajouter(boolean bord) {
        double[] siens = strate(bord);
        double part = (double) tailles[bord ? 1 : 0] / Arrays.stream(tailles).sum() / Math.max(1, siens.length);
        double moyenne = Arrays.stream(siens).average().orElse(0);
        carre += part * Arrays.stream(siens).sum();
        variance += part * part * Arrays.stream(siens).map(c -> (c - moyenne) * (c - moyenne)).sum();
        // un écart aussi grand que le plus grand vu, ou dans le reste comme ceux des bords, a pu manquer plusieurs fois
        double grand = Arrays.stream(siens).max().orElse(0);
        double voisin = bord ? 0 : Arrays.stream(strate(true)).average().orElse(0);
        double manque = part * ZERO_VU / NORMALE * Math.max(0, Math.max(grand, voisin));
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
        Mesure gain = new Mesure(tailles, bords, IntStream.range(0, carres.length)
                .mapToDouble(k -> carres[k] - autre.carres[k]).toArray(), false);
        return gain.carre + ecartsTypes * Math.sqrt(gain.variance);
    }

    /** L'erreur et son intervalle ; ou, là où rien n'est vu, ce qui peut manquer. */
    public String enMots() {
        if (!rienVu) {
            return String.format(Locale.ROOT, "erreur de %.2f ± %.2f", erreur, incertitude);
        }
        return "aucun écart sur " + carres.length + " pixels" + (carres.length == Arrays.stream(tailles).sum() ? ""
                : " ; un détail de moins d'un pixel sur " + carres.length / 3 + " peut manquer");
    }
}
