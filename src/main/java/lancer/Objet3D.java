package lancer;

/**
 * Objet que rencontre un rayon : une forme et une matière (cours, « Éclairage diffus » à « Reflets »). Une forme
 * nouvelle définit {@link #getIntersectionDistance} et {@link #getNormale}. Elle peut aussi redéfinir
 * {@link #getPointDeSurface}, qui corrige les arrondis du contact, {@link #getEnveloppe} et {@link #getKd(Point)}.
 */
public abstract class Objet3D {

    private Couleur Kd = new Couleur();
    private Couleur Ks = new Couleur();
    private double ns = 1;

    /**
     * Cherche le premier contact du rayon avec cet objet, et note la distance dans le rayon, même si elle est +∞.
     *
     * @return la plus petite distance strictement positive, +∞ s'il n'y en a pas
     */
    public abstract double getIntersectionDistance(Rayon incident);

    /**
     * Une sphère qui contient tout l'objet : un rayon qui ne la rencontre pas n'est pas comparé à l'objet. Elle ne sert
     * qu'à la vitesse.
     *
     * @return {@code null}, la valeur par défaut, pour un objet sans borne : tous les rayons lui sont comparés
     */
    public Sphere getEnveloppe() {
        return null;
    }

    /** La normale en un point de la surface : vers l'extérieur, de longueur 1. */
    public abstract Vecteur getNormale(Point contact);

    /**
     * Le point de la surface le plus proche d'un contact qu'un arrondi en a écarté ; par défaut, le contact lui-même.
     *
     * @param distance du contact au départ de son rayon
     */
    public Point getPointDeSurface(Point contact, double distance) {
        return contact;
    }

    /** La direction où cette surface renvoie un rayon : R = V − 2 (V·N) N, miroir de V, de longueur 1. */
    public Vecteur getReflexion(Vecteur V, Vecteur N) {
        return V.add(-2 * V.dot(N), N).normalized();
    }

    /**
     * La couleur que voit le rayon au point de contact : Lambert, plus le reflet des lampes (de Phong, max(0, R·L)^ns,
     * ou celui d'une variante), plus le reflet des objets, s'il peut encore se voir.
     *
     * <p>Sous 325 octets de code, HotSpot la recopierait dans elle-même par ses reflets : une première image de dix
     * boules demanderait un quart de temps de plus, ou davantage.
     *
     * @param contact le contact de {@code incident} avec cet objet
     * @param profondeur nombre de réflexions encore permises
     */
    public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
        Vecteur V = incident.getV();
        Vecteur N = getNormale(contact);
        Vecteur R = getReflexion(V, N);
        Couleur diffusion = getKd(contact);
        Couleur couleur = new Couleur();
        for (Lampe lampe : scene.getLampes()) {
            Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
            // le signe de N·L suffit : une lampe exactement sur le contact n'a pas de direction L
            if (N.dot(versLampe) > 0) {
                Vecteur L = versLampe.normalized();
                Couleur KL = lampe.getCouleur();
                double cosinus = Math.min(1, N.dot(L));
                double eclat = Ks.estNoire() ? 0 : scene.getModele().getSpecularite().eclat(V, N, L, R, ns);
                Couleur diffus = diffusion.mul(KL).mul(cosinus);
                Couleur reflet = Ks.mul(KL).mul(eclat);
                Couleur apport = diffus.add(reflet);
                if (!apport.estNoire() && !scene.estCachee(lampe, contact, L, versLampe.norme(), this)) {
                    couleur = couleur.add(apport);
                }
            }
        }
        Couleur produitKs = incident.getProduitKs().mul(Ks);
        if (profondeur > 0 && !Ks.estNoire() && produitKs.max() >= scene.getModele().getSeuil()) {
            Rayon reflechi = Rayon.reflechi(contact, R, produitKs);
            Couleur vue = scene.getCouleurVue(reflechi, this, profondeur - 1);
            couleur = couleur.add(Ks.mul(vue));
        }
        return couleur;
    }

    /** La couleur de diffusion en ce point : celle de la matière, sauf si une forme a un motif. */
    public Couleur getKd(Point contact) {
        return Kd;
    }

    /** Prend la matière d'un autre objet. */
    public void setMatiere(Objet3D autre) {
        Kd = autre.Kd;
        Ks = autre.Ks;
        ns = autre.ns;
    }

    /** Couleur de diffusion de la matière, composantes dans [0, 1]. */
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

    /** Exposant ns du reflet des lampes, dans [0, 1e9] : plus il est grand, plus la tache brillante est petite. */
    public double getNs() {
        return ns;
    }

    public void setNs(double ns) {
        this.ns = ns;
    }
}
