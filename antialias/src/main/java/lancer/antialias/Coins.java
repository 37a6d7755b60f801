package lancer.antialias;

import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * La méthode du cours (« Anticrénelage ») : les quatre sous-pixels des coins d'abord, et tous les autres si ces quatre
 * couleurs, limitées à [0, 1], diffèrent de plus que le seuil sur une composante. Immuable.
 */
final class Coins implements Echantillonnage {

    private final int n;
    private final double seuil;

    /**
     * @param n nombre de sous-pixels sur un côté
     * @param seuil 0 : tous les sous-pixels, toujours
     */
    Coins(int n, double seuil) {
        this.n = n;
        this.seuil = seuil;
    }

    /** @return le nombre de pixels pour lesquels il a fallu plus que les quatre coins */
    @Override
    public int tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
        SousPixels sousPixels = new SousPixels(n, voulus, vue);
        int raffines = 0;
        for (int j = 0; j < voulus.j1 - voulus.j0; j++) {
            for (int i = 0; i < voulus.i1 - voulus.i0; i++) {
                // jusqu'à n = 2, les coins sont déjà tous les sous-pixels
                boolean complet = n > 2 && (seuil == 0 || contraste(sousPixels.voir(i, j, 0, 0),
                        sousPixels.voir(i, j, n - 1, 0), sousPixels.voir(i, j, 0, n - 1),
                        sousPixels.voir(i, j, n - 1, n - 1)) > seuil);
                int pas = complet ? 1 : Math.max(1, n - 1);
                int nombre = 0;
                Couleur somme = new Couleur();
                for (int dy = 0; dy < n; dy += pas) {
                    for (int dx = 0; dx < n; dx += pas) {
                        somme = somme.add(sousPixels.voir(i, j, dx, dy));
                        nombre++;
                    }
                }
                vue.diviser(somme, nombre);
                toile.drawPixel(somme.div(nombre), voulus.i0 + i, voulus.j0 + j);
                raffines += complet ? 1 : 0;
            }
            sousPixels.oublier(j);
        }
        return raffines;
    }

    /** Le plus grand écart entre quatre couleurs telles qu'on les verra, sur une composante : de 0 à 1. */
    static double contraste(Couleur a, Couleur b, Couleur c, Couleur d) {
        return Math.max(etendue(a.r, b.r, c.r, d.r),
                Math.max(etendue(a.v, b.v, c.v, d.v), etendue(a.b, b.b, c.b, d.b)));
    }

    /** Étendue, sans Math.min ni Math.max, dont le soin pour NaN et −0.0 doublerait le temps de la méthode. */
    private static double etendue(double a, double b, double c, double d) {
        double minAB = a < b ? a : b;
        double maxAB = a < b ? b : a;
        double minCD = c < d ? c : d;
        double maxCD = c < d ? d : c;
        return limite(maxAB < maxCD ? maxCD : maxAB) - limite(minAB < minCD ? minAB : minCD);
    }

    private static double limite(double x) {
        return x < 0 ? 0 : x > 1 ? 1 : x;
    }
}
