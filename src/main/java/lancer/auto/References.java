package lancer.auto;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/**
 * Deux références de quelques blocs : les couleurs moyennes de leurs pixels, chacune à une erreur près, sans rapport
 * avec celle de l'autre, et sans biais si aucune moyenne ne passe 1 : un reflet bien plus vif, et trop petit pour être
 * vu par tous les points, est limité trop tôt. Toujours les mêmes pour un bloc et tant de points, faits en une fois ou
 * en plusieurs.
 */
final class References {

    private static final double POINTS_POUR_UN_NIVEAU = 14;
    private static final int POINTS_MIN = 12;
    private static final int POINTS_MAX = 90;

    final List<Pave> blocs;
    private final Essais essais;
    private final LimitesDesReflets limites;

    /** De chaque bloc, pour chacun de ses pixels, la somme des points de l'une, puis de l'autre. */
    final Couleur[][] sommes;
    private int points;

    /** Ce que coûte à toutes un point de plus par pixel, en rayons de toutes sortes. */
    private double parPoint;

    References(Essais essais, List<Pave> blocs, LimitesDesReflets limites) {
        this.essais = essais;
        this.blocs = blocs;
        this.limites = limites;
        sommes = new Couleur[blocs.size()][2 * Essais.COTE * Essais.COTE];
        for (Couleur[] somme : sommes) {
            Arrays.fill(somme, new Couleur());
        }
        parPoint = 2 * limites.rayons * Essais.pixels(blocs);
    }

    /**
     * Leur ajoute des points, assez pour mesurer une erreur de cet ordre ; aucune grille régulière n'a les leurs, et
     * n'en est donc favorisée.
     *
     * @param rayons permis ; s'ils n'y suffisent pas, autant de points qu'ils en font, et toujours un
     * @return faux si elles en avaient déjà autant
     */
    boolean affiner(double erreur, double rayons) {
        int voulus = (int) Math.max(1, Math.min(pointsPour(erreur), points + rayons / parPoint));
        if (voulus <= points) {
            return false;
        }
        long avant = essais.rayons();
        essais.passer(blocs, (rang, bloc, fil) -> {
            Vue vue = fil.vue(limites.reflets, limites.seuil);
            SplittableRandom hasard = new SplittableRandom((long) bloc.j0 << Integer.SIZE | bloc.i0);
            for (int k = 0; k < sommes[rang].length; k++) {
                int i = bloc.i0 + k / 2 % Essais.COTE;
                int j = bloc.j0 + k / 2 / Essais.COTE;
                double dx = hasard.nextDouble();
                double dy = hasard.nextDouble();
                for (int p = points; p < voulus && bloc.contient(i, j); p++) {
                    sommes[rang][k] = sommes[rang][k].add(vue.couleur(i + Niveaux.x(p, dx), j + Niveaux.y(p, dy)));
                }
            }
        });
        parPoint = (essais.rayons() - avant) / (double) (voulus - points);
        points = voulus;
        return true;
    }

    /** Combien de points pour une erreur de cet ordre : le double produit s'y annule assez. */
    static int pointsPour(double erreur) {
        return (int) Math.max(POINTS_MIN, Math.min(POINTS_MAX, POINTS_POUR_UN_NIVEAU * Math.pow(erreur, -4.0 / 3)));
    }

    /**
     * De chaque bloc, tel qu'il est dessiné : le carré moyen de l'écart à la moyenne exacte du pixel, en niveaux²,
     * rapporté à un bloc entier. Parfois négatif, mais sans biais : pour deux références a et b, c'est (x − a)(x − b),
     * où leurs erreurs s'annulent en moyenne au lieu de s'ajouter.
     */
    double[] ecarts(Niveaux[] dessines) {
        double[] ecarts = new double[dessines.length];
        for (int rang = 0; rang < ecarts.length; rang++) {
            double[] niveaux = dessines[rang].niveaux;
            for (int k = 0; k < niveaux.length; k++) {
                ecarts[rang] += (niveaux[k] - niveau(rang, k, 0)) * (niveaux[k] - niveau(rang, k, 1)) / niveaux.length;
            }
        }
        return ecarts;
    }

    private double niveau(int rang, int k, int laquelle) {
        return Niveaux.de(sommes[rang][2 * (k / 3) + laquelle].div(points))[k % 3];
    }
}
