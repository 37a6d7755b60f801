package lancer.rapide;

import lancer.Constantes;
import lancer.contrat.Compteurs;
import lancer.precision.Intersection;

/**
 * État qu'un fil garde à côté de ses questions aux structures : un compte, la distance trouvée, une pile.
 *
 * <p>Le compte borne ce que coûtent les structures, quoi qu'on leur demande. Il s'ouvre, vide, à chaque rayon de
 * l'écran ; chacun des rayons qui en naissent y met {@link #PAR_RAYON} examens. Une structure y prend ce qu'elle
 * examine, et quand il est vide elle passe la main à l'arbre, qui recommence ; pour une première rencontre, il y remet
 * autant qu'il a examiné. Un dessin examine donc au plus, structures et arbre, 32 sphères ou cases par rayon, et deux
 * fois ce qu'examine l'arbre. Rien ne passe d'un rayon de l'écran à l'autre : les comptes ne dépendent ni des fils, ni
 * de ce qui a été dessiné avant.
 */
final class EtatDeRecherche {

    /** Examens permis de plus à chaque rayon : 32, moins la case d'une carte, qu'elle ne prend pas au compte. */
    static final int PAR_RAYON = 31;

    /** Examens qui restent permis aux structures, depuis ce rayon de l'écran. */
    long credit;

    /** Numéro de la sphère qui a caché une lampe en dernier depuis ce rayon de l'écran, -1 s'il n'y en a pas. */
    int bloqueur;

    /** Distance du dernier contact trouvé, +∞ s'il n'y en a pas, et sa sphère, -1. */
    double distance;
    int trouvee;

    /**
     * État d'une descente dans un arbre : ce qui reste à visiter, d'où le rayon y entre, et leur nombre. Une
     * {@link Grille} y note les sphères qu'elle a tranchées.
     */
    final int[] pile = new int[Noeuds.PROFONDEUR_MAX];
    final double[] entrees = new double[Noeuds.PROFONDEUR_MAX];
    int haut;

    final Compteurs compteurs;

    EtatDeRecherche(Compteurs compteurs) {
        this.compteurs = compteurs;
    }

    /** Ouvre le compte d'un rayon de l'écran. */
    void ouvrir() {
        credit = 0;
        bloqueur = -1;
    }

    /** Retient la sphère k si elle passe avant celle que le etat retient. */
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

    /** Vrai si le rayon rencontre la sphère k à moins de cette distance. */
    boolean touche(Spheres spheres, int k, double px, double py, double pz, double vx, double vy, double vz,
            double auPlus) {
        compteurs.testsSpheres++;
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
        return d < auPlus && (d >= 0 || trancher(spheres, k, d, auPlus, px, py, pz, vx, vy, vz) < auPlus);
    }

    /** Distance de la sphère k, que {@link Intersection#distanceOuDoute} a laissée en doute ; +∞ si c'est trop. */
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
