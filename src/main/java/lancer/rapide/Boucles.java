package lancer.rapide;

import lancer.Constantes;
import lancer.contrat.Recherche;

/**
 * Les boucles du cours, sur les sphères recopiées : pour si peu de rayons que rien ne vaut d'être construit, ou si peu
 * de sphères que rien ne ferait mieux. Quand le compte ne permet pas toutes les sphères, l'arbre.
 */
final class Boucles implements Intersections, Occultations {

    /** Sphères examinées entre deux regards à l'interruption du fil. */
    private static final int PAS = 1 << 14;

    private final Spheres spheres;
    private final Arbre secours;

    Boucles(Spheres spheres, Arbre secours) {
        this.spheres = spheres;
        this.secours = secours;
    }

    @Override
    public int plusProche(Parcours parcours, double px, double py, double pz, double vx, double vy, double vz,
            int sauf) {
        int n = spheres.nombre;
        long credit = parcours.credit + Comptes.PAR_RAYON;
        if (n > credit) {
            return secours.plusProche(parcours, px, py, pz, vx, vy, vz, sauf);
        }
        parcours.credit = credit - n;
        parcours.distance = Constantes.INFINI;
        parcours.trouvee = -1;
        for (int k = 0; k < n; k++) {
            if (k % PAS == 0) {
                Recherche.obeir();
            }
            if (k != sauf) {
                parcours.examiner(spheres, k, px, py, pz, vx, vy, vz);
            }
        }
        return parcours.trouvee;
    }

    @Override
    public boolean cachee(Parcours parcours, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        int n = spheres.nombre;
        long credit = parcours.credit + Comptes.PAR_RAYON;
        if (n > credit) {
            return secours.cachee(parcours, px, py, pz, vx, vy, vz, distance, sauf);
        }
        int r = 0;
        boolean cachee = false;
        for (; r < n && !cachee; r++) {
            if (r % PAS == 0) {
                Recherche.obeir();
            }
            int k = spheres.deRang[r];
            cachee = k != sauf && parcours.touche(spheres, k, px, py, pz, vx, vy, vz, distance);
        }
        parcours.credit = credit - r;
        return cachee;
    }
}
