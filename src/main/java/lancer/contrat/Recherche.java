package lancer.contrat;

import java.util.concurrent.CancellationException;
import lancer.Objet3D;
import lancer.Rayon;

/**
 * Ce qui propose à un rayon les objets qu'il peut rencontrer. Les deux boucles de {@link lancer.Scene} demandent sa
 * distance à chacun : une recherche propose, elle ne répond pas. Elle appartient à un seul fil.
 */
public interface Recherche {

    /**
     * Les objets à qui demander leur distance, dans un ordre quelconque. Chaque réponse est vérifiée avant l'objet
     * suivant : voir {@link #getDistance}.
     *
     * @param rayon ce qu'il retenait est oublié
     * @param depart l'objet d'où part le rayon ou, pour un rayon d'ombre, l'objet éclairé ; {@code null} pour un rayon
     *     de l'écran
     * @param portee distance à partir de laquelle un contact ne compte plus ; finie pour un rayon d'ombre, sinon +∞
     * @throws CancellationException si ce fil est interrompu
     */
    Iterable<Objet3D> candidats(Rayon rayon, Objet3D depart, double portee);

    /** Dit qu'il n'est plus besoin de proposer un objet plus lointain que cette distance. */
    void limiter(double distance);

    /** De cet objet et de ceux qui ont été proposés à la même distance, le premier dans l'ordre de la scène. */
    Objet3D aEgalite(Objet3D plusProche);

    /** La même recherche pour un autre fil, qui compte les examens dans {@code compteurs}. */
    Recherche pourUnFil(Compteurs compteurs);

    /**
     * La distance d'un objet qui vient d'être demandé : celle qu'il a notée dans le rayon ou, s'il n'a rien noté, celle
     * qu'il rend.
     *
     * @param rayon qui retenait NaN avant la demande
     * @throws ArithmeticException si cette distance est NaN
     */
    static double getDistance(Objet3D objet, Rayon rayon) {
        double distance = rayon.getDistance();
        if (Double.isNaN(distance)) {
            distance = objet.getIntersectionDistance(rayon);
        }
        if (Double.isNaN(distance)) {
            throw new ArithmeticException(objet.getClass().getName() + ".getIntersectionDistance a rendu NaN");
        }
        return distance;
    }

    /** @throws CancellationException si ce fil est interrompu ; il le reste */
    static void obeir() {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("travail interrompu");
        }
    }
}
