package lancer.contrat;

import lancer.Couleur;

/** Effet de l'air sur la couleur que voit chaque rayon, demandé par tous les fils à la fois : elle n'a pas d'état. */
public interface Atmosphere {

    /** L'air de la base : il ne change rien. */
    Atmosphere CLAIRE = new Claire();

    /**
     * @param vue la couleur au bout du rayon
     * @param distance longueur de ce rayon, en unités de la scène ; +∞ si c'est le ciel
     * @return la couleur à son départ, aux composantes finies
     */
    Couleur traverser(Couleur vue, double distance);

    /** Part k de l'air dans ce que voit un rayon de cette longueur, pour l'inspecteur ; NaN : il n'en dit rien. */
    default double k(double distance) {
        return Double.NaN;
    }

    /** L'air transparent ; une classe nommée, car la première lambda coûterait au démarrage. */
    final class Claire implements Atmosphere {
        @Override
        public Couleur traverser(Couleur vue, double distance) {
            return vue;
        }
    }
}
