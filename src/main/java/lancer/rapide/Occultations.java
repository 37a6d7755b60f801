package lancer.rapide;

/** Structure qui cherche si une sphère cache une lampe. Tous les fils la partagent : elle n'a pas d'état. */
interface Occultations {

    /**
     * Dit si le rayon qui part de la lampe (px, py, pz) rencontre une sphère à moins de {@code distance}.
     *
     * @param sauf numéro de la sphère éclairée, ou -1
     */
    boolean cachee(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf);
}
