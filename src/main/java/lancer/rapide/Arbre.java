package lancer.rapide;
/** Un arbre de boîtes. */
final class Arbre {

    static final int PROFONDEUR_MAX = 64;

    private Arbre() {
    }
}
