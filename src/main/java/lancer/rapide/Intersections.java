package lancer.rapide;

/** Une réponse à « quelle sphère ce rayon rencontre-t-il d'abord ? ». Partagée par tous les fils : sans état. */
interface Intersections {

    /**
     * Laisse la distance dans {@code parcours}. De deux sphères à la même distance, celle qui vient d'abord dans la
     * scène.
     *
     * @param sauf numéro de la sphère d'où part le rayon, ou -1
     * @return le numéro d'une sphère, -1 s'il n'y en a pas
     */
    int plusProche(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz, int sauf);
}
