package lancer.rapide;

/** Structure qui cherche si une sphère cache une lampe. Tous les fils la partagent : elle n'a pas d'état. */
interface Occultations {

    /** Dit si ce rayon de la lampe rencontre avant {@code distance} une autre sphère que {@code sauf}, ou -1. */
    boolean cachee(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf);
}
