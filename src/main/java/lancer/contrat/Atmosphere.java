package lancer.contrat;

import lancer.Couleur;

/** Effet de l'air sur la couleur que voit un rayon. Tous les fils appellent le même objet, qui n'a pas d'état. */
public interface Atmosphere {

    /** L'air transparent, celui de la base. */
    Atmosphere CLAIRE = (vue, distance) -> vue;

    /**
     * @param vue la couleur à l'arrivée du rayon
     * @param distance longueur du rayon, en unités de la scène ; +∞ pour le ciel
     * @return la couleur à son départ, aux composantes finies
     */
    Couleur traverser(Couleur vue, double distance);

    /** Part k de l'air dans la couleur, pour l'inspecteur ; NaN si l'air n'en a pas. */
    default double k(double distance) {
        return Double.NaN;
    }
}
