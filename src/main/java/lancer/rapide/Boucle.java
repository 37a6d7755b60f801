package lancer.rapide;

import lancer.Constantes;
import lancer.Sphere;

/** Toutes les sphères, l'une après l'autre : ce qu'il y a de plus rapide quand elles sont peu. */
final class Boucle implements Voisins, Obstacles {

    private final Spheres spheres;

    Boucle(Spheres spheres) {
        this.spheres = spheres;
    }

    @Override
    public int plusProche(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf) {
        double[] g = spheres.geometrie;
        double distance = Constantes.INFINI;
        int trouvee = -1;
        int n = spheres.nombre;
        for (int k = 0, i = 0; k < n; k++, i += Spheres.PAS) {
            if (k != sauf) {
                double d = Sphere.distanceOuDoute(px, py, pz, vx, vy, vz, g[i], g[i + 1], g[i + 2], g[i + 3]);
                if (d < 0) {
                    d = sonde.trancher(spheres, k, px, py, pz, vx, vy, vz);
                }
                if (d <= distance && spheres.avant(d, k, distance, trouvee)) {
                    distance = d;
                    trouvee = k;
                }
            }
        }
        sonde.compteurs.testsSpheres += sauf < 0 ? n : n - 1;
        sonde.distance = distance;
        return trouvee;
    }

    @Override
    public boolean cachee(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        double[] g = spheres.geometrie;
        int n = spheres.nombre;
        int tests = 0;
        boolean cachee = false;
        for (int k = 0, i = 0; k < n && !cachee; k++, i += Spheres.PAS) {
            if (k != sauf) {
                tests++;
                double d = Sphere.distanceOuDoute(px, py, pz, vx, vy, vz, g[i], g[i + 1], g[i + 2], g[i + 3]);
                cachee = (d >= 0 ? d : sonde.trancher(spheres, k, px, py, pz, vx, vy, vz)) < distance;
            }
        }
        sonde.compteurs.testsSpheres += tests;
        return cachee;
    }
}
