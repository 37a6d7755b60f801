package lancer.mesures;

import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * La moyenne de n × n sous-pixels réguliers, vus en leurs centres : ce vers quoi tend tout anticrénelage quand n grandit.
 * Écrite ici sans rien du module {@code antialias}, pour pouvoir le juger. Immuable.
 */
final class Moyenne implements Echantillonnage {

    private final int n;

    /** @param n nombre de sous-pixels sur un côté, au moins 1 */
    Moyenne(int n) {
        this.n = n;
    }

    @Override
    public int tracer(Pave pave, Vue vue, Toile toile) {
        for (int j = pave.j0; j < pave.j1; j++) {
            for (int i = pave.i0; i < pave.i1; i++) {
                toile.drawPixel(pixel(vue, i, j), i, j);
            }
        }
        return 0;
    }

    private Couleur pixel(Vue vue, int i, int j) {
        double r = 0;
        double v = 0;
        double b = 0;
        for (int dy = 0; dy < n; dy++) {
            for (int dx = 0; dx < n; dx++) {
                Couleur couleur = vue.couleur(i + (dx + 0.5) / n, j + (dy + 0.5) / n);
                r += couleur.r;
                v += couleur.v;
                b += couleur.b;
            }
        }
        double nombre = n * n;
        return new Couleur(r / nombre, v / nombre, b / nombre);
    }
}
