package lancer.rapide;

import lancer.Camera;
import lancer.Constantes;
import lancer.Sphere;

/**
 * Ce que voit l'œil : ses rayons partent de l'écran, où que ce soit dans un pixel, et tous s'éloignent d'un même point. Une
 * {@link Carte} dont la fenêtre est l'image donne donc leurs sphères de la plus proche à la plus lointaine.
 */
final class CarteOeil implements Voisins {

    private static final double PAR_FOCALE = 1 / Camera.FOCALE;

    private final Spheres spheres;
    private final Carte carte;
    private final Voisins secours;

    CarteOeil(Spheres spheres, Carte carte, Voisins secours) {
        this.spheres = spheres;
        this.carte = carte;
        this.secours = secours;
    }

    @Override
    public int plusProche(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf) {
        Carte q = carte;
        int c = q.casePlane(px * PAR_FOCALE, py * PAR_FOCALE);
        if (c < 0) {
            return secours.plusProche(sonde, px, py, pz, vx, vy, vz, sauf);
        }
        sonde.compteurs.noeudsVisites++;
        int debut = q.debut[c];
        int fin = q.debut[c + 1];
        if (debut == fin) {
            sonde.distance = Constantes.INFINI;
            return -1;
        }
        double[] g = spheres.geometrie;
        // les distances de la carte partent de l'œil : V = (P − Œil) / ‖P − Œil‖, V.z = FOCALE / ‖P − Œil‖
        double avance = Camera.FOCALE / vz * (1 + 1e-12);
        double distance = Constantes.INFINI;
        int trouvee = -1;
        int tests = 0;
        for (int e = debut; e < fin && q.pres[e] - avance <= distance; e++) {
            int k = q.entrees[e];
            tests++;
            int s = Spheres.PAS * k;
            double d = Sphere.distance(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
            if (d <= distance && spheres.avant(d, k, distance, trouvee)) {
                distance = d;
                trouvee = k;
            }
        }
        sonde.compteurs.testsSpheres += tests;
        sonde.distance = distance;
        return trouvee;
    }
}
