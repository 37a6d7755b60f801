package lancer.rapide;

/**
 * Les reflets dans une poignée de sphères : pour chacune, une {@link Carte} de ce qu'un rayon qui la quitte peut rencontrer,
 * d'où qu'il parte de sa surface. Un rayon qui part de la sphère A et touche B passe à moins de rA + rB du centre de B, vu de
 * celui de A : c'est la carte du centre de A où chaque sphère est grossie de rA. La plupart des directions ne montrent que le ciel.
 */
final class Departs implements Voisins {

    /** Côté des six faces, en cases : 12 ne dessine pas plus vite (10 et 24 boules) et se construit en 3 à 5 ms de plus. */
    private static final int COTE = 8;

    /** Grossissement de plus : le contact d'où part le rayon n'est sur la sphère qu'à quelques arrondis près. */
    private static final double MARGE = 1e-9;

    private final Carte[] cartes;
    private final Voisins secours;
    private final double departMax;

    Departs(Spheres spheres, double portee, Voisins secours) {
        this.secours = secours;
        departMax = 2 * portee;
        cartes = new Carte[spheres.nombre];
        Face[] faces = Faces.cube(COTE);
        for (int k = 0; k < cartes.length; k++) {
            cartes[k] = Carte.deLaSurface(spheres, k, MARGE * portee, faces);
        }
    }

    @Override
    public int plusProche(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf) {
        // une sphère immense, un contact très loin : les arrondis dépassent la marge
        if (sauf < 0 || !(Math.max(Math.abs(px), Math.max(Math.abs(py), Math.abs(pz))) <= departMax)) {
            return secours.plusProche(sonde, px, py, pz, vx, vy, vz, sauf);
        }
        return cartes[sauf].plusProche(sonde, vx, vy, vz, 0, px, py, pz, vx, vy, vz);
    }
}
