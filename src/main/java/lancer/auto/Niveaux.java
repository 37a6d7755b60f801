package lancer.auto;

import java.util.SplittableRandom;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/** Les couleurs des pixels d'un bloc, limitées à [0, 1] et en niveaux : de quoi en comparer deux dessins. */
final class Niveaux implements Toile {

    private static final double NIVEAUX = 255;

    private final Pave bloc;
    private final double[] niveaux = new double[3 * Essais.COTE * Essais.COTE];

    Niveaux(Pave bloc) {
        this.bloc = bloc;
    }

    /**
     * Deux références du bloc : les couleurs moyennes de ses pixels, chacune à une erreur près, sans biais et sans
     * rapport avec celle de l'autre. Toujours les mêmes pour un bloc.
     *
     * @param reseau les points d'un pixel ; aucune grille régulière n'a les siens, et n'en est donc favorisée
     */
    static Niveaux[] references(Pave bloc, Vue vue, Reseau reseau) {
        SplittableRandom hasard = new SplittableRandom((long) bloc.j0 << Integer.SIZE | bloc.i0);
        return new Niveaux[] {reference(bloc, vue, reseau, hasard), reference(bloc, vue, reseau, hasard)};
    }

    private static Niveaux reference(Pave bloc, Vue vue, Reseau reseau, SplittableRandom hasard) {
        Niveaux reference = new Niveaux(bloc);
        for (int j = bloc.j0; j < bloc.j1; j++) {
            for (int i = bloc.i0; i < bloc.i1; i++) {
                double dx = hasard.nextDouble();
                double dy = hasard.nextDouble();
                Couleur somme = new Couleur();
                for (int k = 0; k < reseau.points; k++) {
                    somme = somme.add(vue.couleur(i + reseau.x(k, dx), j + reseau.y(k, dy)));
                }
                reference.drawPixel(somme.div(reseau.points), i, j);
            }
        }
        return reference;
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
        return new double[] {niveau(couleur.r), niveau(couleur.v), niveau(couleur.b)};
    }

    private static double niveau(double composante) {
        return NIVEAUX * limite(composante);
    }

    static double limite(double composante) {
        return Math.max(0, Math.min(1, composante));
    }

    /**
     * Le carré moyen de l'écart à la moyenne exacte du pixel, en niveaux², rapporté à un bloc entier. Parfois négatif,
     * mais sans biais : pour deux références a et b, c'est (x − a)(x − b), où leurs erreurs s'annulent en moyenne au
     * lieu de s'ajouter.
     */
    double ecart(Niveaux[] references) {
        double somme = 0;
        for (int k = 0; k < niveaux.length; k++) {
            somme += (niveaux[k] - references[0].niveaux[k]) * (niveaux[k] - references[1].niveaux[k]);
        }
        return somme / niveaux.length;
    }
}
