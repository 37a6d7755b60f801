package lancer.fenetre.vue;

import lancer.fenetre.etat.Etat;

/** Ce qui montre une part de l'état. */
interface Vue {

    void montrer(Etat etat);
}
