package lancer.auto;

/** Le carré d'une erreur quadratique moyenne, estimé sans biais, en niveaux², et sa variance. Immuable. */
final class Estimation {

    /** Une erreur qui n'est pas mesurée : elle est de 0 à 255. */
    static final Estimation INCONNUE = new Estimation(0, 255.0 * 255 * 255 * 255 / 4);

    private final double carre;
    private final double variance;

    Estimation(double carre, double variance) {
        this.carre = Math.max(0, carre);
        this.variance = variance;
    }

    /** L'erreur en niveaux, si le carré s'écarte de l'estimation de ce nombre d'écarts types. */
    double plus(double ecartsTypes) {
        return Math.sqrt(Math.max(0, carre + ecartsTypes * Math.sqrt(variance)));
    }

    /** Estimation d'un réglage dont l'erreur est multipliée par {@code rapport}. @param dispersion de son carré */
    Estimation prolongee(double rapport, double dispersion) {
        double fois = rapport * rapport;
        return new Estimation(fois * carre, fois * fois * (variance + dispersion * dispersion * carre * carre));
    }

    /** Moyenne avec une mesure, pondérée par l'inverse des variances (filtre de Kalman, 1960). */
    Estimation corrigee(Estimation mesure) {
        double gain = variance == 0 ? 0 : variance / (variance + mesure.variance);
        return new Estimation(carre + gain * (mesure.carre - carre), gain * mesure.variance);
    }

    /** Moyenne de deux estimations indépendantes, de même poids. */
    Estimation moyenne(Estimation autre) {
        return new Estimation((carre + autre.carre) / 2, (variance + autre.variance) / 4);
    }
}
