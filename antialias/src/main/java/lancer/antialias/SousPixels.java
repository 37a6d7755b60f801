package lancer.antialias;

import java.util.Arrays;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/** Les sous-pixels d'un pavé, partagés par les pixels voisins et calculés une seule fois. Un seul fil les utilise. */
final class SousPixels {

    /** Nombre de sous-pixels d'un morceau de ligne : la plupart ne sont jamais vus, et ne prennent aucune place. */
    private static final int MORCEAU = 8;

    private final int n;
    private final Pave pave;
    private final Vue vue;
    /** Les lignes de sous-pixels, par morceaux ; {@code null} là où aucun n'a été calculé. */
    private final Couleur[][][] lignes;

    SousPixels(int n, Pave pave, Vue vue) {
        this.n = n;
        this.pave = pave;
        this.vue = vue;
        lignes = new Couleur[(pave.j1 - pave.j0) * n][][];
    }

    /**
     * La couleur d'un sous-pixel, vu en son centre : xe = i + (dx + 1/2)/n, ye = j + (dy + 1/2)/n.
     *
     * @param x colonne, en sous-pixels, depuis la gauche du pavé
     * @param y ligne, en sous-pixels, depuis le haut du pavé
     */
    Couleur voir(int x, int y) {
        Couleur[][] ligne = lignes[y];
        if (ligne == null) {
            ligne = new Couleur[((pave.i1 - pave.i0) * n - 1) / MORCEAU + 1][];
            lignes[y] = ligne;
        }
        Couleur[] morceau = ligne[x / MORCEAU];
        if (morceau == null) {
            morceau = new Couleur[MORCEAU];
            ligne[x / MORCEAU] = morceau;
        }
        if (morceau[x % MORCEAU] == null) {
            morceau[x % MORCEAU] = vue.couleur(pave.i0 + x / n + (x % n + 0.5) / n,
                    pave.j0 + y / n + (y % n + 0.5) / n);
        }
        return morceau[x % MORCEAU];
    }

    /** Libère la mémoire d'une ligne de pixels, devenue inutile. */
    void oublier(int j) {
        Arrays.fill(lignes, j * n, (j + 1) * n, null);
    }
}
