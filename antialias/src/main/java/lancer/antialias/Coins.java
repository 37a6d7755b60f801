package lancer.antialias;

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
    public int tracer(Pave pave, Vue vue, Toile toile) {
        Echantillons echantillons = new Echantillons(n, vue);
        int raffines = 0;
        for (int j = pave.j0; j < pave.j1; j++) {
            for (int i = pave.i0; i < pave.i1; i++) {
                echantillons.commencer(i, j);
                // jusqu'à n = 2, les coins sont déjà tous les sous-pixels
                boolean complet = n > 2 && (seuil == 0 || contraste(echantillons) > seuil);
                toile.drawPixel(complet || n < 2 ? echantillons.moyenne() : echantillons.moyenneDesCoins(), i, j);
                raffines += complet ? 1 : 0;
            }
        }
        return raffines;
    }

    @Override
    public int tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
        return tracer(voulus, vue, toile);
    }

    private double contraste(Echantillons echantillons) {
        return Contraste.entre(echantillons.voir(0, 0), echantillons.voir(n - 1, 0), echantillons.voir(0, n - 1),
                echantillons.voir(n - 1, n - 1));
    }
}
