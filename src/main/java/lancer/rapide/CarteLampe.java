package lancer.rapide;

import lancer.Sphere;

/**
 * Ce qui cache une lampe : elle est ponctuelle et le cours fait partir d'elle les rayons d'ombre, donc elle voit la scène comme
 * une seconde caméra, dans une {@link Carte} (« light buffer », Haines et Greenberg, 1986). Une question coûte une ou deux sphères au
 * lieu d'une descente d'arbre : cinq à neuf fois moins.
 */
final class CarteLampe implements Obstacles {

    private final Spheres spheres;
    private final Carte carte;
    /** Pour les rares questions auxquelles la carte ne sait pas répondre. */
    private final Obstacles secours;

    CarteLampe(Spheres spheres, Carte carte, Obstacles secours) {
        this.spheres = spheres;
        this.carte = carte;
        this.secours = secours;
    }

    @Override
    public boolean cachee(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, double distance,
            int sauf) {
        double[] g = spheres.geometrie;
        Carte q = carte;
        int tests = 0;
        boolean cachee = false;
        int c = q.caseDe(vx, vy, vz);
        if (c >= 0) {
            sonde.compteurs.noeudsVisites++;
            if (distance > q.coupe[c]) {
                // ou bien le contact est sur la sphère qui coupe, un rien plus loin qu'elle par un arrondi
                return q.coupeuse[c] != sauf || secours.cachee(sonde, px, py, pz, vx, vy, vz, distance, sauf);
            }
            int fin = q.debut[c + 1];
            for (int e = q.debut[c]; e < fin && q.pres[e] < distance; e++) {
                int k = q.entrees[e];
                if (k != sauf) {
                    tests++;
                    int s = Spheres.PAS * k;
                    if (Sphere.distance(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]) < distance) {
                        cachee = true;
                        break;
                    }
                }
            }
        }
        sonde.compteurs.testsSpheres += tests;
        return cachee;
    }
}
