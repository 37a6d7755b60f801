package lancer.auto;

import java.util.List;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/** Les couleurs des pixels d'un bloc, limitées à [0, 1] et en niveaux : de quoi en comparer deux dessins. */
final class Niveaux implements Toile {

    private static final double NIVEAUX = 255;

    /** Ce que promet d'erreur un bloc où l'on ne voit qu'une couleur : aucun n'est à l'abri d'un détail. */
    private static final double IMPREVU = 0.1;
    private static final int POINTS_D_UNE_PROMESSE = 8;

    /** Le nombre plastique, solution de x³ = x + 1. */
    private static final double PLASTIQUE = 1.3247179572447460;

    private final Pave bloc;
    final double[] niveaux = new double[3 * Essais.COTE * Essais.COTE];

    Niveaux(Pave bloc) {
        this.bloc = bloc;
    }

    /** Le point k d'une suite bien répartie dans le carré unité (Roberts, suite R2, 2018) : son abscisse. */
    static double x(int k, double decalage) {
        return (decalage + k / PLASTIQUE) % 1;
    }

    static double y(int k, double decalage) {
        return (decalage + k / PLASTIQUE / PLASTIQUE) % 1;
    }

    /** Les pixels d'à côté ne comptent pas. */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        if (bloc.contient(xe, ye)) {
            System.arraycopy(de(coul), 0, niveaux, 3 * ((ye - bloc.j0) * Essais.COTE + xe - bloc.i0), 3);
        }
    }

    /** Les trois composantes. */
    static double[] de(Couleur couleur) {
        return new double[] {NIVEAUX * limite(couleur.r), NIVEAUX * limite(couleur.v), NIVEAUX * limite(couleur.b)};
    }

    private static double limite(double composante) {
        return Math.max(0, Math.min(1, composante));
    }

    /** Ce que chacun de ces blocs promet d'erreur, d'après quelques points du bloc et d'un demi-pixel autour. */
    static double[] promesses(Essais essais, List<Pave> blocs, LimitesDesReflets limites) {
        double[] promesses = new double[blocs.size()];
        essais.passer(blocs, (rang, bloc, fil) -> {
            Vue vue = fil.vue(limites.reflets, limites.seuil);
            double[] vus = new double[3 * POINTS_D_UNE_PROMESSE];
            for (int k = 0; k < POINTS_D_UNE_PROMESSE; k++) {
                Couleur couleur = vue.couleur(bloc.i0 - 0.5 + x(k, 0) * (bloc.i1 - bloc.i0 + 1),
                        bloc.j0 - 0.5 + y(k, 0) * (bloc.j1 - bloc.j0 + 1));
                System.arraycopy(de(couleur), 0, vus, 3 * k, 3);
            }
            promesses[rang] = promesse(vus);
        });
        return promesses;
    }

    /** Ce que promet d'erreur un bloc où l'on voit ces composantes : d'autant plus qu'elles diffèrent. */
    static double promesse(double[] vus) {
        double contraste = 0;
        for (int c = 0; c < 3; c++) {
            double min = NIVEAUX;
            double max = 0;
            for (int k = c; k < vus.length; k += 3) {
                min = Math.min(min, vus[k]);
                max = Math.max(max, vus[k]);
            }
            contraste = Math.max(contraste, max - min);
        }
        return IMPREVU + contraste / NIVEAUX;
    }
}
