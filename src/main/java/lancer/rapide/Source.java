package lancer.rapide;

/**
 * Ce qui donne à une question, liste après liste, toutes les enveloppes que son rayon peut rencontrer : celles qui se
 * voient dans sa direction ({@link Visee}), celles des cubes qu'il traverse ({@link Marche}), ou celles des boîtes de
 * l'arbre où il entre ({@link Descente}).
 */
interface Source {

    /** Nombre d'examens d'un rayon au-delà duquel l'arbre remplace une autre source. */
    int EXAMENS_MAX = 100;

    /** Ce que répond une source : une liste, plus rien, ou trop d'objets, et c'est à l'arbre de répondre. */
    enum Suite { LISTE, FIN, TROP }

    /**
     * Donne la liste suivante. Une enveloppe plus lointaine que la limite peut y manquer.
     *
     * @param liste reçoit les rangs, et compte les examens
     * @param limite distance au-delà de laquelle un contact ne compte plus
     */
    Suite suivante(Liste liste, double limite);
}
