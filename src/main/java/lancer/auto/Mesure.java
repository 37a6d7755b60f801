package lancer.auto;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.IntToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * L'erreur quadratique moyenne d'une image, en niveaux, estimée sur des pixels tirés avec des chances inégales. Chacun
 * compte comme l'inverse de sa chance (W. G. Cochran, <i>Sampling Techniques</i>, 1977, ch. 9A). Immuable.
 */
public final class Mesure {

    /** Quantile à 97,5 % de la loi normale ; de ce que l'on n'a pas vu, le plus grand nombre attendu, à 97,5 %. */
    private static final double NORMALE = 1.96;
    private static final double ZERO_VU = 3.69;
    /** Le carré d'un demi-niveau : en dessous, une couleur est juste. */
    private static final double JUSTE = 0.25;

    /** L'erreur ; la plus grande de ses distances aux bornes de son intervalle de confiance à 95 %. */
    public final double erreur;
    public final double incertitude;
    /** Vrai si aucun pixel tiré ne s'écarte de ses références : rien ne se sait alors des autres. */
    public final boolean rienVu;
    private final double[] poids;
    private final double plusGrand;
    private final double[] carres;
    private final double carre;
    /** L'écart type de ce carré ; puis, vers le haut, celui qui tient compte de ce qui a pu manquer. */
    private final double bas;
    private final double haut;

    /**
     * @param poids nombre de pixels que représente chaque pixel tiré
     * @param carres le carré de son erreur, estimé sans biais, en niveaux²
     */
    Mesure(double[] poids, double[] carres) {
        this.poids = poids;
        this.carres = carres;
        double tous = Arrays.stream(poids).sum();
        plusGrand = Arrays.stream(poids).max().orElse(1);
        carre = pourChacun(k -> poids[k] * carres[k]).sum() / tous;
        bas = Math.sqrt(pourChacun(k -> Math.pow(poids[k] * (carres[k] - carre), 2)).sum()) / tous;
        // plusieurs écarts comme le plus grand ont pu manquer
        double manque = pourChacun(k -> poids[k] * carres[k]).reduce(0, Math::max) / tous;
        haut = Math.hypot(bas, ZERO_VU / NORMALE * manque);
        rienVu = Arrays.stream(carres).allMatch(c -> Math.abs(c) <= JUSTE);
        erreur = plus(0);
        incertitude = Math.max(erreur - plus(-NORMALE), plus(NORMALE) - erreur);
    }

    private DoubleStream pourChacun(IntToDoubleFunction nombre) {
        return IntStream.range(0, poids.length).mapToDouble(nombre);
    }

    /** L'erreur, si son carré s'écarte de ce nombre d'écarts types. */
    double plus(double ecartsTypes) {
        return Math.sqrt(Math.max(0, carre + ecartsTypes * (ecartsTypes > 0 ? haut : bas)));
    }

    /** Ce que l'autre réglage ôte à l'erreur. Le hasard des références, le même pour les deux, y disparaît. */
    Mesure moins(Mesure autre) {
        return new Mesure(poids, pourChacun(k -> carres[k] - autre.carres[k]).toArray());
    }

    /** L'erreur et son intervalle, ou qu'aucun écart n'a été vu ; et ce qui peut manquer. */
    public String enMots() {
        String vu = rienVu ? "aucun écart sur " + poids.length + " pixels"
                : String.format(Locale.ROOT, "erreur de %.2f ± %.2f", erreur, incertitude);
        double detail = Arrays.stream(poids).sum() / plusGrand / 3;
        return plusGrand == 1 ? vu
                : String.format(Locale.ROOT, "%s ; un détail de moins d'un pixel sur %.0f peut manquer", vu, detail);
    }
}
