package lancer;

/** Ce qu'un rayon peut rencontrer, et sa matière (cours, « Éclairage diffus » à « Reflets »). */
public abstract class Objet3D {

    private Couleur Kd = new Couleur();
    private Couleur Ks = new Couleur();
    private double ns = 1;

    /** La distance du plus proche contact du rayon, +∞ s'il n'y en a pas ; elle est aussi notée dans le rayon. */
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
        //{ compléter, étape par étape : l'éclairement diffus, le spéculaire, les ombres, puis les reflets
        Vecteur V = incident.getV();
        Vecteur N = getNormale(contact);
        Vecteur R = V.sub(N.mul(2 * N.dot(V)));
        Couleur couleur = new Couleur();
        for (Lampe lampe : scene.getLampes()) {
            Vecteur L = new Vecteur(contact, lampe.getPosition()).normalized();
            double cosinus = N.dot(L);
            if (cosinus > 0 && !estALOmbre(scene, lampe, contact)) {
                Couleur diffus = Kd.mul(lampe.getCouleur()).mul(cosinus);
                //<blinn
                double eclat = Math.pow(Math.max(0, R.dot(L)), ns);
                //+ Vecteur H = L.sub(V).normalized();
                //+ double eclat = Math.pow(Math.max(0, N.dot(H)), ns);
                //>
                Couleur speculaire = Ks.mul(lampe.getCouleur()).mul(eclat);
                couleur = couleur.add(diffus).add(speculaire);
            }
        }
        if (profondeur > 0) {
            Rayon reflechi = new Rayon(contact, R);
            PointContact suivant = scene.getClosestIntersection(reflechi, (Sphere) this);
            Couleur reflet = suivant == null ? reflechi.getSkyColor()
                    : suivant.objet.getColor(scene, reflechi, suivant, profondeur - 1);
            //<brume
            //+ reflet = scene.getBrume().devant(reflet, reflechi.getDistance());
            //>
            couleur = couleur.add(Ks.mul(reflet));
        }
        return couleur;
        //= return new Couleur(1, 1, 0);
        //}
    }

    //{
    /** Un rayon part de la lampe vers le contact : si un autre objet l'arrête avant, le contact est à l'ombre. */
    private boolean estALOmbre(Scene scene, Lampe lampe, Point contact) {
        Rayon rayon = new Rayon(lampe.getPosition(), contact);
        PointContact obstacle = scene.getClosestIntersection(rayon, (Sphere) this);
        return obstacle != null && obstacle.distance < new Vecteur(lampe.getPosition(), contact).norme();
    }

    //}
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
