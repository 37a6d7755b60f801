package lancer.antialias;

import java.util.Arrays;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/** Les sous-pixels d'un pavé, chacun vu au plus une fois, partagés par les pixels voisins. N'appartient qu'à un fil. */
final class SousPixels {

    private final int n;
    private final Pave pave;
    private final Vue vue;
    private final int largeur;
    /** Pour chaque pixel, ligne par ligne : son premier sous-pixel, puis les autres ; ceux-ci manquent à la plupart. */
    private final Couleur[] premiers;
    private final Couleur[][] autres;

    SousPixels(int n, Pave pave, Vue vue) {
        this.n = n;
        this.pave = pave;
        this.vue = vue;
        largeur = pave.i1 - pave.i0;
        premiers = new Couleur[largeur * (pave.j1 - pave.j0)];
        autres = new Couleur[premiers.length][];
    }

    /**
     * La couleur d'un sous-pixel.
     *
     * @param i colonne du pixel, depuis la gauche du pavé
     * @param j ligne du pixel, depuis le haut du pavé
     * @param dx colonne dans le pixel ; n est la première du pixel suivant
     * @param dy ligne dans le pixel ; n est la première du pixel suivant
     */
    Couleur voir(int i, int j, int dx, int dy) {
        int pixel = j * largeur + i;
        int x = dx;
        int y = dy;
        if (x == n) {
            pixel++;
            x = 0;
        }
        if (y == n) {
            pixel += largeur;
            y = 0;
        }
        if (x + y == 0) {
            if (premiers[pixel] == null) {
                premiers[pixel] = lancer(pixel, 0, 0);
            }
            return premiers[pixel];
        }
        Couleur[] reste = autres[pixel];
        if (reste == null) {
            reste = new Couleur[n * n];
            autres[pixel] = reste;
        }
        int k = y * n + x;
        if (reste[k] == null) {
            reste[k] = lancer(pixel, x, y);
        }
        return reste[k];
    }

    private Couleur lancer(int pixel, int x, int y) {
        return vue.couleur(pave.i0 + pixel % largeur + (x + 0.5) / n, pave.j0 + pixel / largeur + (y + 0.5) / n);
    }

    /** Rend la mémoire d'une ligne de pixels, qui ne sera plus vue. */
    void oublier(int j) {
        Arrays.fill(autres, j * largeur, (j + 1) * largeur, null);
    }
}
