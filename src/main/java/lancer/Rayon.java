package lancer;

/**
 * Une demi-droite (P, V), et le contact le plus proche déjà trouvé sur elle (cours, « Représentation des rayons »). P
 * et V ne changent pas. Le contact change pendant la recherche : un rayon appartient à un seul fil d'exécution.
 */
public class Rayon {

    private static final Couleur BLANC = new Couleur(1);

    private final Point P;
    private final Vecteur V;
    private final Couleur produitKs;
    private double distance = Constantes.INFINI;
    private Objet3D objet;

    /**
     * Le rayon qui part de {@code p1} et va vers {@code p2}.
     *
     * @throws ArithmeticException si les deux points sont confondus ou ne sont pas finis
     */
    public Rayon(Point p1, Point p2) {
        this(p1, new Vecteur(p1, p2));
    }

    /**
     * Le rayon qui part de {@code p} dans la direction de {@code v}.
     *
     * @param v de longueur quelconque
     * @throws ArithmeticException si {@code v} est nul ou n'est pas fini
     */
    public Rayon(Point p, Vecteur v) {
        this(p, v.normalized(), BLANC);
    }

    private Rayon(Point p, Vecteur v, Couleur produitKs) {
        P = p;
        V = v;
        this.produitKs = produitKs;
    }

    /** Le rayon de direction {@code v}, qui est déjà de longueur 1. */
    public static Rayon unitaire(Point p, Vecteur v) {
        return new Rayon(p, v, BLANC);
    }

    /** Le rayon que renvoie {@code p}, de direction {@code r} normalisée. @param produitKs des Ks jusqu'à p compris */
    public static Rayon reflechi(Point p, Vecteur r, Couleur produitKs) {
        return new Rayon(p, r, produitKs);
    }

    /** Le point de départ. */
    public Point getP() {
        return P;
    }

    /** La direction, de longueur 1. */
    public Vecteur getV() {
        return V;
    }

    /** La distance du contact retenu, +∞ s'il n'y en a pas. */
    public double getDistance() {
        return distance;
    }

    /** L'objet du contact retenu, {@code null} s'il n'y en a pas. */
    public Objet3D getObjet() {
        return objet;
    }

    /** Le produit des Ks des objets qui ont réfléchi ce rayon ; (1, 1, 1) avant toute réflexion. */
    public Couleur getProduitKs() {
        return produitKs;
    }

    /** Retient ce contact à la place du précédent. Une distance +∞ signifie qu'il n'y a pas de contact. */
    public void setContact(Objet3D objet, double distance) {
        this.objet = distance == Constantes.INFINI ? null : objet;
        this.distance = distance;
    }

    /** Le point de contact P + distance·V, ramené sur la surface ; {@code null} si la distance est infinie. */
    public PointContact calcContact() {
        return distance == Constantes.INFINI ? null
                : new PointContact(objet.getPointDeSurface(P.add(distance, V), distance), objet, distance);
    }

    /** La couleur du ciel dans la direction du rayon : bleu au-dessus de l'horizon, brun au-dessous. */
    public Couleur getSkyColor() {
        if (V.y > 0) {
            double bas = 1 - V.y;
            return new Couleur(Constantes.CIEL.r * bas, Constantes.CIEL.v * bas, Constantes.CIEL.b * bas + V.y);
        }
        return new Couleur(Constantes.SOL.r, Constantes.SOL.v + Constantes.SOL_ASSOMBRI * V.y, Constantes.SOL.b);
    }
}
