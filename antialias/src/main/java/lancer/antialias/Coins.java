package lancer.antialias;

import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Releve;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * La méthode du cours (« Anticrénelage ») : d'abord les quatre sous-pixels des coins. Si leurs couleurs, limitées à [0,
 * 1], diffèrent de plus que le seuil sur une composante, tous les autres sous-pixels s'y ajoutent. Immuable.
 */
final class Coins implements Echantillonnage {

    private final int n;
    private final double seuil;

    /** @param n nombre de sous-pixels sur un côté @param seuil contraste ; 0 pour tous les sous-pixels */
    Coins(int n, double seuil) {
        this.n = n;
        this.seuil = seuil;
    }

    /** @return avec le nombre de pixels qui ont tous leurs sous-pixels */
    @Override
    public Releve tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
        SousPixels sousPixels = new SousPixels(n, voulus, vue);
        int dernier = n - 1;
        int raffines = 0;
        for (int j = 0; j < voulus.j1 - voulus.j0; j++) {
            for (int i = 0; i < voulus.i1 - voulus.i0; i++) {
                int x = i * n;
                int y = j * n;
                // si n vaut 1 ou 2, les coins sont tous les sous-pixels
                boolean complet = n > 2 && (seuil == 0 || contraste(sousPixels.voir(x, y),
                        sousPixels.voir(x + dernier, y), sousPixels.voir(x, y + dernier),
                        sousPixels.voir(x + dernier, y + dernier)) > seuil);
                int pas = complet ? 1 : Math.max(1, dernier);
                int nombre = 0;
                Couleur somme = new Couleur();
                for (int dy = 0; dy < n; dy += pas) {
                    for (int dx = 0; dx < n; dx += pas) {
                        somme = somme.add(sousPixels.voir(x + dx, y + dy));
                        nombre++;
                    }
                }
                toile.drawPixel(somme.div(nombre), voulus.i0 + i, voulus.j0 + j);
                raffines += complet ? 1 : 0;
            }
            sousPixels.oublier(j);
        }
        return new Releve(raffines);
    }

    /** Le plus grand écart entre quatre couleurs limitées à [0, 1], sur une composante. */
    static double contraste(Couleur a, Couleur b, Couleur c, Couleur d) {
        return Math.max(etendue(a.r, b.r, c.r, d.r),
                Math.max(etendue(a.v, b.v, c.v, d.v), etendue(a.b, b.b, c.b, d.b)));
    }

    /** Écart des extrêmes, limités à [0, 1]. Math.min et Math.max, qui voient NaN, seraient plus lents. */
    private static double etendue(double a, double b, double c, double d) {
        double minAB = a < b ? a : b;
        double maxAB = a < b ? b : a;
        double minCD = c < d ? c : d;
        double maxCD = c < d ? d : c;
        double min = minAB < minCD ? minAB : minCD;
        double max = maxAB < maxCD ? maxCD : maxAB;
        return limite(max) - limite(min);
    }

    static double limite(double x) {
        double pasTrop = x > 1 ? 1 : x;
        return x < 0 ? 0 : pasTrop;
    }
}
