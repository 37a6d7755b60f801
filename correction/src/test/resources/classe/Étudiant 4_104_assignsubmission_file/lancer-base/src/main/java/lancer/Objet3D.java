package lancer;

/** Ce qu'un rayon peut rencontrer, et sa matière (cours, « Éclairage diffus » à « Reflets »). */
public abstract class Objet3D {

    private Couleur Kd = new Couleur();
    private Couleur Ks = new Couleur();
    private double ns = 1;

    /** La distance du plus proche contact du rayon avec cet objet, +∞ s'il n'y en a pas ; elle est aussi notée dans le rayon. */
    public abstract double getIntersectionDistance(Rayon incident);

    /** La normale en un point de la surface : vers l'extérieur, de longueur 1. */
    public abstract Vecteur getNormale(Point contact);

    /**
     * La couleur que voit un rayon au point où il rencontre cet objet.
     *
     * @param contact le contact de {@code incident} avec cet objet
     * @param profondeur le nombre de reflets encore permis
     */
    public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
        Vecteur N = getNormale(contact);
        Couleur couleur = new Couleur();
        for (Lampe lampe : scene.getLampes()) {
            Vecteur L = new Vecteur(contact, lampe.getPosition());
            double cosinus = N.dot(L);
            if (cosinus > 0) {
                couleur = couleur.add(Kd.mul(lampe.getCouleur()).mul(cosinus));
            }
        }
        return couleur;
    }

    public Couleur getKd() {
        return Kd;
    }

    public void setKd(Couleur Kd) {
        this.Kd = Kd;
    }

    public Couleur getKs() {
        return Ks;
    }

    public void setKs(Couleur Ks) {
        this.Ks = Ks;
    }

    public double getNs() {
        return ns;
    }

    public void setNs(double ns) {
        this.ns = ns;
    }
}
