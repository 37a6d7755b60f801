package lancer.rapide;

/** Une réponse à « une autre sphère cache-t-elle cette lampe ? ». Partagée par tous les fils : sans état. */
interface Occultations {

    /**
     * Vrai si le rayon qui part de la lampe (px, py, pz) rencontre une sphère à moins de {@code distance}.
     *
     * @param sauf numéro de la sphère éclairée, ou -1
     */
    boolean cachee(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf);
}
