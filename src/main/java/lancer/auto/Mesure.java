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

    /** Nombre de pixels en dessous duquel leur dispersion ne donne pas d'intervalle. */
    private static final int ASSEZ = 6;
    /** Part du carré de l'erreur que porte un seul pixel tiré, au-dessus de laquelle ses semblables sont rares. */
    private static final double RARE = 0.3;

    /** L'erreur ; la plus grande de ses distances aux bornes de son intervalle de confiance à 95 %. */
    public final double erreur;
    public final double incertitude;
    /** Faux si trop peu de pixels sont tirés, ou si aucun ne s'écarte de ses références : rien ne se sait du reste. */
    public final boolean aUnIntervalle;
    private final boolean rienVu;
    /** Vrai si l'image a des détails si rares que l'échantillon n'en a rencontré qu'un. */
    private final boolean rares;
    private final double[] poids;
    private final double plusGrand;
    private final double[] carres;
    private final double carre;
    /** L'écart type de ce carré, et celui qui y ajoute, vers le haut, ce qui a pu manquer. */
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
        haut = bas + ZERO_VU / NORMALE * manque;
        rienVu = Arrays.stream(carres).allMatch(c -> Math.abs(c) <= JUSTE);
        aUnIntervalle = !rienVu && poids.length >= ASSEZ;
        rares = aUnIntervalle && plusGrand > 1 && carre > 0 && manque > RARE * carre;
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

    /** L'erreur et son intervalle, ou qu'aucun écart n'a été vu ; et ce qui a pu échapper. */
    public String enMots() {
        double detail = Arrays.stream(poids).sum() / plusGrand / 3;
        return direLErreur() + (rares ? " hors détails rares" : "") + (plusGrand == 1 ? ""
                : String.format(Locale.ROOT, " ; pixels tirés au hasard : un détail plus petit que 1/%.0f de l'image a "
                + "pu échapper", detail));
    }

    private String direLErreur() {
        if (rienVu) {
            return "aucun écart sur " + poids.length + " pixels";
        }
        if (!aUnIntervalle) {
            return String.format(Locale.ROOT, "erreur de %.2f, sans intervalle : l'image est trop petite", erreur);
        }
        // une estimation négative du carré ne dit que la borne du haut
        return carre <= 0 ? String.format(Locale.ROOT, "erreur d'au plus %.2f", incertitude)
                : String.format(Locale.ROOT, "erreur de %.2f ± %.2f", erreur, incertitude);
    }
}
