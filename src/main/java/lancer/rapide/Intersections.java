package lancer.rapide;

/** Structure qui cherche la première sphère d'un rayon. Tous les fils la partagent : elle n'a pas d'état. */
interface Intersections {

    /**
     * Met la distance dans {@code etat}. À distance égale, la sphère qui vient d'abord dans la scène l'emporte.
     *
     * @param sauf numéro de la sphère d'où part le rayon, ou -1
     * @return le numéro d'une sphère, -1 s'il n'y en a pas
     */
    int plusProche(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz, int sauf);
}
