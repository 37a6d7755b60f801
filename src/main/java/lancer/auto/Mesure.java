package lancer.auto;

import java.util.Arrays;

/** Une erreur quadratique moyenne, en niveaux, dont une moyenne estime le carré. Immuable. */
public final class Mesure {

    /** Quantile à 97,5 % de la loi normale ; plus petite incertitude annoncée, en niveaux. */
    private static final double NORMALE = 1.96;
    private static final double MOINDRE = 0.01;

    /** L'erreur ; la plus grande de ses distances aux bornes de son intervalle de confiance à 95 %. */
    public final double erreur;
    public final double incertitude;
    private final double carre;
    private final double variance;

    /** @param carres estimations indépendantes et sans biais du même carré, en niveaux² ; au moins une */
    Mesure(double... carres) {
        double moyenne = Arrays.stream(carres).average().getAsDouble();
        carre = Math.max(0, moyenne);
        variance = Arrays.stream(carres).map(c -> (c - moyenne) * (c - moyenne)).sum() / carres.length
                / Math.max(1, carres.length - 1);
        erreur = plus(0);
        incertitude = Math.max(MOINDRE, Math.max(erreur - plus(-NORMALE), plus(NORMALE) - erreur));
    }

    /** L'erreur, si son carré s'écarte de la moyenne de ce nombre d'écarts types. */
    double plus(double ecartsTypes) {
        return Math.sqrt(Math.max(0, carre + ecartsTypes * Math.sqrt(variance)));
    }
}
