package lancer.rapide;

import lancer.contrat.Compteurs;
import lancer.precision.Intersection;

/** Ce qu'un fil garde à côté de ses questions aux structures : la distance trouvée, une pile, ses comptes. */
final class Parcours {

    /** Distance du dernier contact trouvé, +∞ s'il n'y en a pas. */
    double distance;

    /** De quoi descendre un arbre. */
    final int[] pile = new int[Noeuds.PROFONDEUR_MAX];
    final double[] entrees = new double[Noeuds.PROFONDEUR_MAX];

    final Compteurs compteurs;

    /** La sphère de ce contact, -1 s'il n'y en a pas. */
    int trouvee;

    /** Où une marche dans une {@link Grille} s'est arrêtée sur une sphère en doute, et ce doute. */
    double doute;
    int arretCase;
    int arretEntree;
    int resteX;
    int resteY;
    int resteZ;
    double tx;
    double ty;
    double tz;

    Parcours(Compteurs compteurs) {
        this.compteurs = compteurs;
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

    /** La distance de la sphère k, que {@link Intersection#distanceOuDoute} a laissée en doute. */
    double trancher(Spheres spheres, int k, double px, double py, double pz, double vx, double vy, double vz) {
        compteurs.testsPrecis++;
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        return Intersection.trancher(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
    }
}
