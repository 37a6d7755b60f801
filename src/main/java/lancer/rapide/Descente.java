package lancer.rapide;

import lancer.Point;
import lancer.Vecteur;

/** Les feuilles de l'arbre où entre un rayon, de la boîte la plus proche à la plus lointaine. */
final class Descente implements Source {

    /** Plus petite composante de la direction dont l'inverse sert, à la place d'une plus petite : rien n'y déborde. */
    private static final double COMPOSANTE_MIN = 1e-180;

    private final Structures structures;
    private Arbre arbre;
    private Point p;

    /** Les inverses de la direction, et l'élargissement d'une boîte pour ce rayon. */
    private double ix;
    private double iy;
    private double iz;
    private double marge;

    /** La pile : nœuds à visiter, distances où le rayon y entre, et leur nombre. */
    private int[] noeuds;
    private double[] entrees;
    private int hauteur;

    Descente(Structures structures) {
        this.structures = structures;
    }

    /** Place ce rayon à la racine. */
    void commencer(Point depart, Vecteur direction) {
        if (arbre == null) {
            arbre = structures.getArbre();
            noeuds = new int[Arbre.PROFONDEUR_MAX];
            entrees = new double[Arbre.PROFONDEUR_MAX];
        }
        p = depart;
        ix = inverse(direction.x);
        iy = inverse(direction.y);
        iz = inverse(direction.z);
        marge = Arbre.MARGE * Enveloppes.plusGrande(p.x, p.y, p.z);
        hauteur = arbre.feuilles.length == 0 ? 0 : 1;
        noeuds[0] = 0;
        entrees[0] = 0;
    }

    static double inverse(double v) {
        return 1 / (Math.abs(v) < COMPOSANTE_MIN ? COMPOSANTE_MIN : v);
    }

    @Override
    public Suite suivante(Liste liste, double limite) {
        while (hauteur > 0) {
            hauteur--;
            int feuille = entrees[hauteur] <= limite ? descendre(noeuds[hauteur], liste, limite) : -1;
            if (feuille >= 0) {
                int debut = arbre.suite[feuille];
                liste.donner(arbre.feuilles, debut, debut + arbre.compte[feuille]);
                return Suite.LISTE;
            }
        }
        return Suite.FIN;
    }

    /**
     * Descend de ce nœud à une feuille, par l'enfant le plus proche ; l'autre va dans la pile.
     *
     * @return −1 si le rayon n'en rencontre aucune avant la limite
     */
    private int descendre(int depart, Liste liste, double limite) {
        int noeud = depart;
        while (noeud >= 0 && arbre.compte[noeud] == 0) {
            liste.examens += 2;
            int enfant = arbre.suite[noeud];
            double e0 = entree(Arbre.PAS * enfant);
            double e1 = entree(Arbre.PAS * enfant + Arbre.PAS);
            if (e0 <= limite && e1 <= limite) {
                boolean gauche = e0 <= e1;
                noeuds[hauteur] = gauche ? enfant + 1 : enfant;
                entrees[hauteur++] = gauche ? e1 : e0;
                noeud = gauche ? enfant : enfant + 1;
            } else if (e0 <= limite) {
                noeud = enfant;
            } else {
                noeud = e1 <= limite ? enfant + 1 : -1;
            }
        }
        return noeud;
    }

    /** La distance où le rayon entre dans la boîte de cette place, arrondie par défaut ; NaN s'il ne la touche pas. */
    private double entree(int b) {
        double[] q = arbre.boites;
        double x = (q[b] - p.x) * ix;
        double y = (q[b + 1] - p.y) * iy;
        double z = (q[b + 2] - p.z) * iz;
        double ex = (q[b + 3] + marge) * Math.abs(ix);
        double ey = (q[b + 4] + marge) * Math.abs(iy);
        double ez = (q[b + 5] + marge) * Math.abs(iz);
        double entree = Math.max(x - ex, Math.max(y - ey, z - ez));
        double sortie = Math.min(x + ex, Math.min(y + ey, z + ez));
        return entree <= sortie && sortie >= 0 ? entree : Double.NaN;
    }
}
