package lancer.rapide;

import lancer.Constantes;
import lancer.contrat.Compteurs;
import lancer.precision.Intersection;

/**
 * État d'un fil pendant ses recherches : un crédit d'examens, le dernier contact, une pile.
 *
 * <p>Le crédit borne le coût des structures. Il est nul au départ d'un rayon de l'écran. Ce rayon, puis chaque rayon
 * qui en naît, y ajoute {@link #PAR_RAYON} examens ; chaque examen d'une structure en retire un. Quand le crédit est
 * épuisé, l'arbre recommence la recherche. Si l'arbre cherche un premier contact, il ajoute au crédit le nombre de ses
 * examens. Un dessin examine donc au plus 32 sphères ou cases par rayon, plus deux fois les examens de l'arbre seul. Ce
 * crédit ne passe pas au rayon de l'écran suivant : les compteurs ne dépendent ni des fils, ni d'un dessin d'avant.
 */
final class EtatDeRecherche {

    /** Examens permis de plus par rayon : 32, moins la case d'une carte, que le crédit ne compte pas. */
    static final int PAR_RAYON = 31;

    /** Nombre d'examens encore permis aux structures pour ce rayon de l'écran. */
    long credit;

    /** Sphère qui a caché une lampe en dernier depuis ce rayon de l'écran, -1 s'il n'y en a pas. */
    int bloqueur;

    /** Distance du dernier contact, +∞ s'il n'y en a pas ; numéro de sa sphère, ou -1. */
    double distance;
    int trouvee;

    /** Pile d'un arbre : nœuds à visiter, distances d'entrée, hauteur ; une {@link Grille} y note les doutes levés. */
    final int[] pile = new int[Noeuds.PROFONDEUR_MAX];
    final double[] entrees = new double[Noeuds.PROFONDEUR_MAX];
    int haut;

    final Compteurs compteurs;

    EtatDeRecherche(Compteurs compteurs) {
        this.compteurs = compteurs;
    }

    void ouvrir() {
        credit = 0;
        bloqueur = -1;
    }

    /** Retient la sphère k si son contact précède celui qui est retenu. */
    void retenir(Spheres spheres, int k, double px, double py, double pz, double vx, double vy, double vz) {
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
        if (d < 0) {
            d = trancher(spheres, k, d, distance, px, py, pz, vx, vy, vz);
        }
        if (d <= distance && Spheres.avant(d, k, distance, trouvee)) {
            distance = d;
            trouvee = k;
        }
    }

    /** Dit si le rayon rencontre la sphère k à moins de {@code auPlus}. */
    boolean touche(Spheres spheres, int k, double px, double py, double pz, double vx, double vy, double vz,
            double auPlus) {
        compteurs.testsSpheres++;
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
        return d < auPlus && (d >= 0 || trancher(spheres, k, d, auPlus, px, py, pz, vx, vy, vz) < auPlus);
    }

    /** Distance de la sphère k, si {@link Intersection#distanceOuDoute} a un doute ; +∞ au-delà de {@code auPlus}. */
    double trancher(Spheres spheres, int k, double doute, double auPlus, double px, double py, double pz, double vx,
            double vy, double vz) {
        if (Intersection.auMoins(doute) > auPlus) {
            return Constantes.INFINI;
        }
        compteurs.testsPrecis++;
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        return Intersection.trancher(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
    }
}
