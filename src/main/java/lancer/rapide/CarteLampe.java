package lancer.rapide;

import lancer.Point;
import lancer.precision.Intersection;

/**
 * Ce qui cache une lampe : elle est ponctuelle et le cours fait partir d'elle les rayons d'ombre, donc elle voit la
 * scène comme une seconde caméra, dans une {@link Carte} (« light buffer », Haines et Greenberg, 1986). Une question
 * coûte une ou deux sphères au lieu d'une descente d'arbre : cinq à neuf fois moins.
 */
final class CarteLampe implements Occultations {

    private final Spheres spheres;
    private final double x;
    private final double y;
    private final double z;
    final Carte carte;
    /** Pour les questions auxquelles la carte ne sait pas répondre, ou pas dans les limites du compte. */
    private final Arbre secours;

    CarteLampe(Spheres spheres, Point lampe, Carte carte, Arbre secours) {
        this.spheres = spheres;
        x = lampe.x;
        y = lampe.y;
        z = lampe.z;
        this.carte = carte;
        this.secours = secours;
    }

    @Override
    public boolean cachee(Parcours parcours, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        Carte q = carte;
        if (!(px == x && py == y && pz == z)) {
            return secours.cachee(parcours, px, py, pz, vx, vy, vz, distance, sauf);
        }
        int c = q.caseDe(vx, vy, vz);
        if (c < 0) {
            return false;
        }
        parcours.compteurs.noeudsVisites++;
        if (distance > q.coupe[c]) {
            // ou bien le contact est sur la sphère qui coupe, un rien plus loin qu'elle par un arrondi
            return q.coupeuse[c] != sauf || secours.cachee(parcours, px, py, pz, vx, vy, vz, distance, sauf);
        }
        double[] g = spheres.geometrie;
        int premiere = q.debut[c];
        int derniere = q.debut[c + 1];
        long credit = parcours.credit + Comptes.PAR_RAYON;
        int fin = derniere - premiere <= credit ? derniere : premiere + (int) credit;
        int tests = 0;
        int e = premiere;
        boolean cachee = false;
        for (; e < fin && !cachee && q.pres[e] < distance; e++) {
            int k = q.entrees[e];
            if (k != sauf) {
                tests++;
                int s = Spheres.PAS * k;
                double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
                cachee = d < distance && (d >= 0 || Intersection.auMoins(d) < distance
                        && parcours.trancher(spheres, k, px, py, pz, vx, vy, vz) < distance);
            }
        }
        parcours.compteurs.testsSpheres += tests;
        parcours.credit = credit - (e - premiere);
        return cachee || e >= fin && e < derniere && q.pres[e] < distance
                && secours.cachee(parcours, px, py, pz, vx, vy, vz, distance, sauf);
    }
}
