package lancer.rapide;

import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/**
 * Recherche d'une scène de beaucoup d'objets. Un rayon de l'écran ou d'une lampe lit une case d'une {@link Carte}. Un
 * rayon réfléchi, ou dont la case n'est pas connue, descend dans l'{@link Arbre}, de la boîte la plus proche à la plus
 * lointaine.
 */
final class Foule implements Recherche {

    private final Enveloppes enveloppes;
    private final int[] libres;
    private final Arbre arbre;
    private final Carte oeil;
    private final Lampe[] lampes;
    private final Carte[] cartes;
    private final Compteurs compteurs;

    /** Rang de la dernière lampe demandée ; en général, la suivante vient juste après. */
    private int lampe;

    /** Départ et direction du rayon en cours. */
    private Point P;
    private Vecteur V;

    /** Place en cours d'une case ou d'une feuille, et place de fin. */
    private int[] liste;
    private int place;
    private int fin;
    /** Distances au point d'une carte, {@code null} hors d'elle, et ce que le rayon a parcouru avant P. */
    private float[] pres;
    private double avance;

    /** Nœuds à visiter, bornes inférieures de leurs distances, hauteur de la pile. */
    private final int[] pile = new int[Arbre.PROFONDEUR_MAX];
    private final double[] entrees = new double[Arbre.PROFONDEUR_MAX];
    private int haut;

    private boolean ombre;
    /** Place du prochain objet libre : ils viennent après une case, et avant l'arbre. */
    private int libre;
    /** L'objet proposé en dernier, −1 à la fin ; celui qui a caché une lampe en dernier ; celui à proposer d'abord. */
    private int propose = -1;
    private int bloqueur = -1;
    private int premier = -1;

    /** @param oeil carte de l'œil, et de chaque lampe ; {@code null} là où l'arbre la remplace */
    Foule(Enveloppes enveloppes, Arbre arbre, Carte oeil, Lampe[] lampes, Carte[] cartes, Compteurs compteurs) {
        this.enveloppes = enveloppes;
        this.arbre = arbre;
        this.oeil = oeil;
        this.cartes = cartes;
        this.lampes = lampes;
        this.compteurs = compteurs;
        libres = enveloppes.libres;
    }

    @Override
    public void commencer(Point P, Vecteur V, Objet3D depart) {
        if (depart == null) {
            bloqueur = -1;
        }
        ombre = false;
        ouvrir(depart == null ? oeil : null, P, V);
    }

    @Override
    public void commencerOmbre(Lampe demandee, Point P, Vecteur V, double distance, Objet3D eclaire) {
        // la boucle qui s'est arrêtée avant la fin a trouvé ce qui cache la lampe
        if (ombre && propose >= 0) {
            bloqueur = propose;
        }
        ombre = true;
        lampe = Enveloppes.trouver(demandee, lampes, lampe);
        ouvrir(lampes.length > 0 && lampes[lampe] == demandee ? cartes[lampe] : null, P, V);
    }

    private void ouvrir(Carte carte, Point depart, Vecteur direction) {
        P = depart;
        V = direction;
        fin = 0;
        haut = 0;
        libre = 0;
        premier = -1;
        pres = null;
        compteurs.noeudsVisites++;
        int c = carte == null ? -1 : carte.point.caseDe(P, V);
        if (c >= 0 && !carte.estPleine(c)) {
            pres = carte.pres;
            avance = carte.point.avance(P, V);
            lire(carte.objets, carte.debut[c], carte.debut[c + 1]);
        } else if (Enveloppes.estUnitaire(V.x, V.y, V.z)
                && Enveloppes.plusGrande(P.x, P.y, P.z) < Enveloppes.LONGUEUR_MAX) {
            pile[0] = 0;
            entrees[0] = 0;
            haut = arbre.feuilles.length == 0 ? 0 : 1;
            premier = ombre ? bloqueur : -1;
        } else {
            lire(enveloppes.bornes, 0, enveloppes.bornes.length);
        }
    }

    private void lire(int[] celle, int debut, int apres) {
        liste = celle;
        place = debut;
        fin = apres;
    }

    @Override
    public int suivant(double auPlus) {
        if (place < fin && (pres == null || pres[liste[place]] - avance <= auPlus)) {
            propose = liste[place++];
        } else {
            propose = suite(auPlus);
        }
        return propose;
    }

    /** Le premier objet proposé avant l'arbre, d'une nouvelle feuille, ou après une case. */
    private int suite(double auPlus) {
        fin = 0;
        if (premier >= 0) {
            int k = premier;
            premier = -1;
            return k;
        }
        if (libre < libres.length) {
            return libres[libre++];
        }
        return descendre(auPlus) ? liste[place++] : -1;
    }

    /** Cherche la feuille suivante. @return faux s'il n'y en a plus */
    private boolean descendre(double auPlus) {
        double[] q = arbre.boites;
        double marge = Arbre.MARGE * Enveloppes.plusGrande(P.x, P.y, P.z);
        double ax = Math.abs(V.x);
        double ay = Math.abs(V.y);
        double az = Math.abs(V.z);
        int visites = 0;
        while (haut > 0) {
            if (entrees[--haut] > auPlus) {
                continue;
            }
            int n = pile[haut];
            // descend par l'enfant le plus proche jusqu'à une feuille ; l'autre enfant va dans la pile
            while (n >= 0 && arbre.compte[n] == 0) {
                visites += 2;
                int s = arbre.suite[n];
                double e0 = entree(q, Arbre.PAS * s, ax, ay, az, marge, auPlus);
                double e1 = entree(q, Arbre.PAS * s + Arbre.PAS, ax, ay, az, marge, auPlus);
                if (e0 <= auPlus && e1 <= auPlus) {
                    boolean gauche = e0 <= e1;
                    pile[haut] = gauche ? s + 1 : s;
                    entrees[haut++] = gauche ? e1 : e0;
                    n = gauche ? s : s + 1;
                } else {
                    n = e0 <= auPlus ? s : e1 <= auPlus ? s + 1 : -1;
                }
            }
            if (n >= 0) {
                compteurs.noeudsVisites += visites;
                lire(arbre.feuilles, arbre.suite[n], arbre.suite[n] + arbre.compte[n]);
                return true;
            }
        }
        compteurs.noeudsVisites += visites;
        return false;
    }

    /**
     * Borne inférieure de la distance du rayon à cette boîte ; NaN s'il ne la rencontre pas. Les axes de séparation
     * sont V et ses produits vectoriels avec les trois axes.
     */
    private double entree(double[] q, int b, double ax, double ay, double az, double marge, double auPlus) {
        double x = q[b] - P.x;
        double y = q[b + 1] - P.y;
        double z = q[b + 2] - P.z;
        double hx = q[b + 3] + marge;
        double hy = q[b + 4] + marge;
        double hz = q[b + 5] + marge;
        if (Math.abs(y * V.z - z * V.y) > hy * az + hz * ay || Math.abs(z * V.x - x * V.z) > hz * ax + hx * az
                || Math.abs(x * V.y - y * V.x) > hx * ay + hy * ax) {
            return Double.NaN;
        }
        double milieu = x * V.x + y * V.y + z * V.z;
        double demi = hx * ax + hy * ay + hz * az;
        return milieu + demi < 0 ? Double.NaN : milieu - demi;
    }

    @Override
    public Recherche pourUnFil(Compteurs siens) {
        return new Foule(enveloppes, arbre, oeil, lampes, cartes, siens);
    }
}
