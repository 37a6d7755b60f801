package lancer.antialias;

import java.util.Arrays;
import lancer.Couleur;
import lancer.contrat.Vue;

/** Les n × n sous-pixels d'un pixel à la fois, chacun vu en son centre, au plus une fois. N'appartient qu'à un fil. */
final class Echantillons {

    private final int n;
    private final Vue vue;
    private final Couleur[] couleurs;
    private int i;
    private int j;

    Echantillons(int n, Vue vue) {
        this.n = n;
        this.vue = vue;
        this.couleurs = new Couleur[n * n];
    }

    /** Commence le pixel de colonne {@code i} et de ligne {@code j} : plus rien n'en est vu. */
    void commencer(int i, int j) {
        this.i = i;
        this.j = j;
        Arrays.fill(couleurs, null);
    }

    /** La couleur du sous-pixel (dx, dy), en xe = i + (dx + 1/2)/n, ye = j + (dy + 1/2)/n. */
    Couleur voir(int dx, int dy) {
        int k = dy * n + dx;
        if (couleurs[k] == null) {
            couleurs[k] = vue.couleur(i + (dx + 0.5) / n, j + (dy + 0.5) / n);
        }
        return couleurs[k];
    }

    /** La moyenne de tous les sous-pixels, sommés ligne par ligne. */
    Couleur moyenne() {
        Couleur somme = new Couleur();
        for (int dy = 0; dy < n; dy++) {
            for (int dx = 0; dx < n; dx++) {
                somme = somme.add(voir(dx, dy));
            }
        }
        return moyenne(somme, n * n);
    }

    /** La moyenne des quatre sous-pixels des coins, dans le même ordre. */
    Couleur moyenneDesCoins() {
        Couleur somme = new Couleur().add(voir(0, 0)).add(voir(n - 1, 0)).add(voir(0, n - 1)).add(voir(n - 1, n - 1));
        return moyenne(somme, 4);
    }

    private Couleur moyenne(Couleur somme, int nombre) {
        vue.diviser(somme, nombre);
        return somme.div(nombre);
    }
}
