package lancer.rapide;

import lancer.contrat.Compteurs;
import lancer.precision.Intersection;

/**
 * Ce qu'un fil garde à côté de ses questions aux structures : le compte du pixel, la distance trouvée, une pile.
 */
final class Parcours {

    /** Examens qui restent permis aux structures, dans ce pixel. */
    long credit;

    /** Numéro de la sphère qui a caché une lampe en dernier dans ce pixel, -1 s'il n'y en a pas. */
    int bloqueur = -1;

    /** Distance du dernier contact trouvé, +∞ s'il n'y en a pas, et sa sphère, -1. */
    double distance;
    int trouvee;

    /**
     * De quoi descendre un arbre : ce qui reste à visiter, d'où le rayon y entre, et leur nombre. Une {@link Grille} y
     * note les sphères qu'elle a tranchées.
     */
    final int[] pile = new int[Noeuds.PROFONDEUR_MAX];
    final double[] entrees = new double[Noeuds.PROFONDEUR_MAX];
    int haut;

    /** Doute de la sphère sur laquelle une marche dans une {@link Grille} s'est arrêtée. */
    double doute;

    final Compteurs compteurs;

    Parcours(Compteurs compteurs) {
        this.compteurs = compteurs;
    }

    /** Examine la sphère k, et la retient si elle passe avant celle que le parcours retient. */
    void examiner(Spheres spheres, int k, double px, double py, double pz, double vx, double vy, double vz) {
        compteurs.testsSpheres++;
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        retenir(spheres, k, Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]),
                px, py, pz, vx, vy, vz);
    }

    /**
     * Retient la sphère k si elle passe avant celle que le parcours retient.
     *
     * @param d réponse de {@link Intersection#distanceOuDoute} pour elle
     */
    void retenir(Spheres spheres, int k, double d, double px, double py, double pz, double vx, double vy, double vz) {
        if (d < 0) {
            if (Intersection.auMoins(d) > distance) {
                return;
            }
            d = trancher(spheres, k, px, py, pz, vx, vy, vz);
        }
        if (d <= distance && spheres.avant(d, k, distance, trouvee)) {
            distance = d;
            trouvee = k;
        }
    }

    /** Vrai si le rayon rencontre la sphère k à moins de cette distance. */
    boolean touche(Spheres spheres, int k, double px, double py, double pz, double vx, double vy, double vz,
            double auPlus) {
        compteurs.testsSpheres++;
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
        return d < auPlus && (d >= 0 || Intersection.auMoins(d) < auPlus
                && trancher(spheres, k, px, py, pz, vx, vy, vz) < auPlus);
    }

    /** La distance de la sphère k, que {@link Intersection#distanceOuDoute} a laissée en doute. */
    double trancher(Spheres spheres, int k, double px, double py, double pz, double vx, double vy, double vz) {
        compteurs.testsPrecis++;
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        return Intersection.trancher(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
    }
}
