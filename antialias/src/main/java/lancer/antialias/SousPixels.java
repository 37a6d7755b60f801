package lancer.antialias;

import java.util.Arrays;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/** Les sous-pixels d'un pavé, partagés par les pixels voisins et calculés une seule fois. Un seul fil les utilise. */
final class SousPixels {

    private final int n;
    private final Pave pave;
    private final Vue vue;
    private final int largeur;
    /** Pour chaque pixel, ligne par ligne : le tableau de son premier sous-pixel ou, s'il en faut d'autres, de tous. */
    private final Couleur[][] pixels;

    SousPixels(int n, Pave pave, Vue vue) {
        this.n = n;
        this.pave = pave;
        this.vue = vue;
        largeur = pave.i1 - pave.i0;
        pixels = new Couleur[largeur * (pave.j1 - pave.j0)][];
    }

    /**
     * La couleur d'un sous-pixel, vu en son centre : xe = i + (dx + 1/2)/n, ye = j + (dy + 1/2)/n.
     *
     * @param i colonne du pixel, depuis la gauche du pavé
     * @param j ligne du pixel, depuis le haut du pavé
     * @param dx colonne dans le pixel ; n désigne la première du pixel suivant
     * @param dy ligne dans le pixel ; n désigne la première du pixel suivant
     */
    Couleur voir(int i, int j, int dx, int dy) {
        int x = dx == n ? 0 : dx;
        int y = dy == n ? 0 : dy;
        int ligne = dy == n ? j + 1 : j;
        int pixel = ligne * largeur + (dx == n ? i + 1 : i);
        int k = y * n + x;
        Couleur[] vus = pixels[pixel];
        if (vus == null) {
            vus = new Couleur[k == 0 ? 1 : n * n];
            pixels[pixel] = vus;
        } else if (k >= vus.length) {
            vus = Arrays.copyOf(vus, n * n);
            pixels[pixel] = vus;
        }
        if (vus[k] == null) {
            vus[k] = vue.couleur(pave.i0 + pixel % largeur + (x + 0.5) / n, pave.j0 + pixel / largeur + (y + 0.5) / n);
        }
        return vus[k];
    }

    /** Libère la mémoire d'une ligne de pixels, devenue inutile. */
    void oublier(int j) {
        Arrays.fill(pixels, j * largeur, (j + 1) * largeur, null);
    }
}
