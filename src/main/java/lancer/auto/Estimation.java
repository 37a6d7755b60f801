package lancer.auto;

/**
 * Une erreur quadratique moyenne, estimée sur quelques blocs d'une image : la racine de la moyenne, sur les pixels et
 * les trois composantes, du carré de l'écart entre couleurs limitées à [0, 1], en niveaux (1/255). C'est celle qui
 * s'extrapole : la moyenne de quelques carrés approche celle de tous, quand le plus grand écart de quelques pixels ne
 * dit rien du plus grand de l'image.
 */
final class Estimation {

    /** Écarts types ajoutés au carré estimé, pour qu'une erreur attendue « au plus » le soit presque toujours. */
    private static final double PRUDENCE = 2;

    /**
     * Et pour borner une mesure à venir : dix-neuf fois sur vingt quelle que soit sa loi, si elle n'a qu'un sommet
     * (Vysochanskij et Petunin, 1980) ; peu de blocs font parfois tout.
     */
    private static final double PRUDENCE_MESURE = 3;

    /** En niveaux², et la variance de ce qui l'estime. */
    final double carre;
    private final double variance;

    Estimation(double carre, double variance) {
        this.carre = carre;
        this.variance = variance;
    }

    /** La moyenne de mesures indépendantes, chacune d'espérance le carré cherché, et ce qu'elle a d'incertain. */
    static Estimation de(double[] mesures) {
        double moyenne = moyenne(mesures);
        double carres = 0;
        for (double mesure : mesures) {
            carres += (mesure - moyenne) * (mesure - moyenne);
        }
        return new Estimation(moyenne, carres / ((double) mesures.length * Math.max(1, mesures.length - 1)));
    }

    static double moyenne(double[] mesures) {
        double somme = 0;
        for (double mesure : mesures) {
            somme += mesure;
        }
        return somme / mesures.length;
    }

    /** L'erreur de deux causes sans rapport : les carrés s'ajoutent, comme leurs incertitudes. */
    Estimation plus(Estimation autre) {
        return new Estimation(carre + autre.carre, variance + autre.variance);
    }

    /** En niveaux. */
    double erreur() {
        return Math.sqrt(carre);
    }

    /** Ce que l'erreur ne devrait pas dépasser, en niveaux. */
    double auPlus() {
        return Math.sqrt(carre + PRUDENCE * Math.sqrt(variance));
    }

    /** Ce qu'elle devrait atteindre, en niveaux. */
    double auMoins() {
        return Math.sqrt(Math.max(0, carre - PRUDENCE * Math.sqrt(variance)));
    }

    /** Ce dont elle peut s'écarter, en niveaux, à deux écarts types du carré : dix-neuf fois sur vingt. */
    double incertitude() {
        // près de zéro, elle peut monter de plus qu'elle ne peut descendre
        return Math.max((auPlus() - auMoins()) / 2, auPlus() - erreur());
    }

    /** Où tomberait une mesure aussi incertaine : entre {@link #auMoins} et {@link #auPlus} de ce qui est rendu. */
    Estimation mesuree() {
        double prudence = PRUDENCE_MESURE / PRUDENCE;
        return new Estimation(carre, 2 * prudence * prudence * variance);
    }
}
