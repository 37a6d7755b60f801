package lancer.antialias;

import java.util.Arrays;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/**
 * Les sous-pixels d'une rangée de cases d'un pavé, chacun vu au plus une fois : n + 1 lignes, dont la dernière est aussi la
 * première de la rangée suivante. N'appartient qu'à un fil.
 */
final class Bande {

    private final int n;
    private final Pave pave;
    private final Vue vue;
    private final int largeur;
    private final Couleur[] couleurs;
    private int haut;

    Bande(int n, Pave pave, Vue vue) {
        this.n = n;
        this.pave = pave;
        this.vue = vue;
        this.largeur = (pave.i1 - pave.i0) * n;
        this.couleurs = new Couleur[(n + 1) * largeur];
    }

    /** Passe à la rangée suivante. */
    void descendre() {
        haut += n;
        System.arraycopy(couleurs, n * largeur, couleurs, 0, largeur);
        Arrays.fill(couleurs, largeur, couleurs.length, null);
    }

    /** Retient la couleur d'un sous-pixel déjà vu. */
    void poser(int x, int y, Couleur couleur) {
        couleurs[(y - haut) * largeur + x] = couleur;
    }

    /**
     * La couleur d'un sous-pixel.
     *
     * @param x colonne de sous-pixels, depuis la gauche du pavé
     * @param y ligne de sous-pixels, depuis le haut du pavé, dans la rangée
     */
    Couleur voir(int x, int y) {
        int k = (y - haut) * largeur + x;
        if (couleurs[k] == null) {
            couleurs[k] = vue.couleur(pave.i0 + (x + 0.5) / n, pave.j0 + (y + 0.5) / n);
        }
        return couleurs[k];
    }
}
