package lancer;

/**
 * Objet que rencontre un rayon : une forme et une matière (cours, « Éclairage diffus » à « Reflets »). Une forme
 * nouvelle n'a que deux méthodes à donner : {@link #getIntersectionDistance} et {@link #getNormale} ; une troisième,
 * {@link #getPointDeSurface}, lui évite les arrondis du contact.
 */
public abstract class Objet3D {

    private Couleur Kd = new Couleur();
    private Couleur Ks = new Couleur();
    private double ns = 1;

    /**
     * Cherche où le rayon touche cet objet, et le note dans le rayon, à la place de ce qui y était (+∞ compris).
     *
     * @return la plus petite distance strictement positive, +∞ s'il n'y en a pas
     */
    public abstract double getIntersectionDistance(Rayon incident);

    /** La normale en un point de la surface : vers l'extérieur, de longueur 1. */
    public abstract Vecteur getNormale(Point contact);

    /**
     * Le point de la surface le plus proche d'un contact, que les arrondis en ont un peu écarté. Une forme qui ne sait
     * pas mieux faire rend le contact lui-même.
     */
    public Point getPointDeSurface(Point contact) {
        return contact;
    }

    /** Le point de la surface le plus proche d'un contact à cette distance du départ de son rayon. */
    Point getPointDeSurface(Point contact, double distance) {
        return getPointDeSurface(contact);
    }

    /**
     * La couleur que voit le rayon au point de contact : Lambert, plus le reflet des lampes, plus le reflet des objets.
     *
     * @param contact le contact de {@code incident} avec cet objet
     * @param profondeur nombre de réflexions encore permises
     */
    public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
        Vecteur V = incident.getV();
        Vecteur N = getNormale(contact);
        Vecteur R = V.add(-2 * V.dot(N), N).normalized();
        Lumiere lumiere = scene.getLumiere(N, R);
        for (Lampe lampe : scene.lampes) {
            Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
            // le signe de N·L se lit avant de normaliser : une lampe exactement sur le contact s'arrête ici aussi
            if (lumiere.estDevant(lampe, N.dot(versLampe))) {
                Vecteur L = versLampe.normalized();
                Couleur KL = lampe.getCouleur();
                double cosinus = Math.min(1, N.dot(L));
                double eclat = Ks.estNoire() ? 0 : scene.getModele().getSpecularite().eclat(V, N, L, R, ns);
                Couleur apport = lumiere.apport(KL, Kd, cosinus, Ks, eclat);
                if (!apport.estNoire() && !scene.estCachee(lampe, contact, L, versLampe.norme(), this)) {
                    lumiere.ajouter(apport);
                }
            }
        }
        if (profondeur > 0 && !Ks.estNoire()) {
            Couleur produitKs = incident.getProduitKs().mul(Ks);
            if (lumiere.vautUnReflet(produitKs)) {
                scene.getCompteurs().reflechis++;
                Rayon reflechi = new Rayon(contact, R, produitKs);
                lumiere.ajouter(Ks.mul(scene.getCouleurVue(reflechi, this, profondeur - 1)));
            }
        }
        return lumiere.getCouleur();
    }

    /** Couleur de diffusion, composantes dans [0, 1]. */
    public Couleur getKd() {
        return Kd;
    }

    public void setKd(Couleur Kd) {
        this.Kd = Kd;
    }

    /** Couleur de réflexion, composantes dans [0, 1]. */
    public Couleur getKs() {
        return Ks;
    }

    public void setKs(Couleur Ks) {
        this.Ks = Ks;
    }

    /** Poli de la surface, dans [0, 1e9] : plus il est grand, plus le reflet d'une lampe est petit. */
    public double getNs() {
        return ns;
    }

    public void setNs(double ns) {
        this.ns = ns;
    }
}
