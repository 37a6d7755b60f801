package lancer.rapide;

import java.util.Arrays;

/** Une suite de rangs, d'objets ou de cases, qui s'allonge. */
final class Rangs {

    int[] rangs = new int[16];
    int nombre;

    void ajouter(int rang) {
        if (nombre == rangs.length) {
            rangs = Arrays.copyOf(rangs, 2 * nombre);
        }
        rangs[nombre++] = rang;
    }
}
