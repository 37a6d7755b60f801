package lancer.mesures;

import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * La moyenne de n × n sous-pixels réguliers, vus en leurs centres, n doublant dans chaque pixel tant que la moyenne change :
 * ce vers quoi tend tout anticrénelage. Écrit sans rien du module {@code antialias}, pour pouvoir le juger. Immuable.
 */
final class Doublement implements Echantillonnage {

    private final int nMin;
    private final int nMax;
    private final double tolerance;
    private final Toile moitie;

    /**
     * @param nMin sous-pixels d'un côté pour commencer ; la première décision en demande deux fois plus
     * @param nMax sous-pixels d'un côté au-delà desquels on ne double plus
     * @param tolerance changement d'une composante au-dessous duquel on ne double plus
     * @param moitie où noter l'image de moitié moins de sous-pixels
     */
    Doublement(int nMin, int nMax, double tolerance, Toile moitie) {
        this.nMin = nMin;
        this.nMax = nMax;
        this.tolerance = tolerance;
        this.moitie = moitie;
    }

    /** @return le nombre de pixels qui changeaient encore quand {@code nMax} les a arrêtés */
    @Override
    public int tracer(Pave pave, Vue vue, Toile toile) {
        int arretes = 0;
        for (int j = pave.j0; j < pave.j1; j++) {
            for (int i = pave.i0; i < pave.i1; i++) {
                arretes += pixel(vue, toile, i, j) ? 1 : 0;
            }
        }
        return arretes;
    }

    /** Vrai s'il changeait encore. */
    private boolean pixel(Vue vue, Toile toile, int i, int j) {
        Couleur avant = moyenne(vue, i, j, nMin);
        for (int n = 2 * nMin; ; n *= 2) {
            Couleur couleur = moyenne(vue, i, j, n);
            boolean change = Erreur.ecart(avant, couleur) > tolerance;
            if (!change || 2 * n > nMax) {
                moitie.drawPixel(avant, i, j);
                toile.drawPixel(couleur, i, j);
                return change;
            }
            avant = couleur;
        }
    }

    private static Couleur moyenne(Vue vue, int i, int j, int n) {
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
