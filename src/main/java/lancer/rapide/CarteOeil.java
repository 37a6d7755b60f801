package lancer.rapide;

import lancer.Camera;

/**
 * Ce que voit l'œil : ses rayons partent de l'écran, où que ce soit dans un pixel, et tous s'éloignent d'un même point. Une
 * {@link Carte} dont la fenêtre est l'image donne donc leurs sphères de la plus proche à la plus lointaine.
 */
final class CarteOeil implements Voisins {

    private static final double PAR_FOCALE = 1 / Camera.FOCALE;

    private final Carte carte;
    private final Voisins secours;

    CarteOeil(Carte carte, Voisins secours) {
        this.carte = carte;
        this.secours = secours;
    }

    @Override
    public int plusProche(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf) {
        // les distances de la carte partent de l'œil : V = (P − Œil) / ‖P − Œil‖, V.z = FOCALE / ‖P − Œil‖
        double avance = Camera.FOCALE / vz * (1 + 1e-12);
        int k = carte.plusProche(sonde, px * PAR_FOCALE, py * PAR_FOCALE, 1, avance, px, py, pz, vx, vy, vz);
        return k == Carte.HORS ? secours.plusProche(sonde, px, py, pz, vx, vy, vz, sauf) : k;
    }
}
