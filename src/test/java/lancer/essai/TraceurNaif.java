package lancer.essai;

import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Vue;

/** Les boucles du cours avec la formule du manuel, et les façons courantes d'y poser une question d'ombre ou de reflet. */
public final class TraceurNaif implements Vue {

    /** Ce qui, entre un contact et une lampe, la cache. */
    public enum Ombre {
        /** Tout ce que touche le rayon qui quitte le contact, l'objet éclairé compris. */
        SANS_EXCLURE,
        /** Tout autre objet, même derrière la lampe. */
        SANS_DISTANCE,
        /** Tout objet que la lampe ne voit pas le premier, le discriminant étant celui du manuel. */
        PREMIER_DU_MANUEL,
        /** Rien. */
        AUCUNE
    }

    private final Camera camera;
    private final List<Objet3D> objets;
    private final List<Lampe> lampes;
    private final int reflets;
    private final Ombre ombre;
    private final double epsilon;

    /** @param epsilon une rencontre plus proche ne compte pas */
    public TraceurNaif(Scene scene, Camera camera, int reflets, Ombre ombre, double epsilon) {
        this.camera = camera;
        objets = scene.getObjets();
        lampes = scene.getLampes();
        this.reflets = reflets;
        this.ombre = ombre;
        this.epsilon = epsilon;
    }

    @Override
    public Couleur couleur(double xe, double ye) {
        return vue(camera.getRayon(xe, ye), reflets);
    }

    private Couleur vue(Rayon rayon, int profondeur) {
        chercher(rayon);
        PointContact contact = rayon.calcContact();
        if (contact == null) {
            return rayon.getSkyColor();
        }
        Vecteur V = rayon.getV();
        Vecteur N = contact.objet.getNormale(contact);
        Couleur couleur = new Couleur();
        for (Lampe lampe : lampes) {
            Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
            Vecteur L = versLampe.normalized();
            // comme le cours, la question part de la lampe
            Point vise = lampe.getPosition().add(versLampe.norme(), L.neg());
            if (N.dot(versLampe) > 0 && !cachee(lampe, vise, contact.objet)) {
                couleur = couleur.add(contact.objet.getKd().mul(lampe.getCouleur()).mul(N.dot(L)));
            }
        }
        Vecteur R = V.add(-2 * V.dot(N), N).normalized();
        Couleur Ks = contact.objet.getKs();
        return profondeur == 0 ? couleur : couleur.add(Ks.mul(vue(Rayon.reflechi(contact, R, Ks), profondeur - 1)));
    }

    /** N'exclut rien : ce qui est à plus d'epsilon compte. */
    private void chercher(Rayon incident) {
        Objet3D meilleur = null;
        double distance = Constantes.INFINI;
        for (Objet3D objet : objets) {
            double d = distance(incident, objet);
            if (d < distance) {
                meilleur = objet;
                distance = d;
            }
        }
        incident.setContact(meilleur, distance);
    }

    public boolean cachee(Lampe lampe, Point contact, Objet3D objet) {
        if (ombre == Ombre.PREMIER_DU_MANUEL) {
            Rayon deLaLampe = new Rayon(lampe.getPosition(), contact);
            chercher(deLaLampe);
            return deLaLampe.getObjet() != objet;
        }
        Rayon versLaLampe = new Rayon(contact, lampe.getPosition());
        double jusque = ombre == Ombre.SANS_DISTANCE ? Constantes.INFINI : new Vecteur(contact, lampe.getPosition()).norme();
        for (Objet3D autre : objets) {
            boolean compte = ombre == Ombre.SANS_EXCLURE || ombre == Ombre.SANS_DISTANCE && autre != objet;
            if (compte && distance(versLaLampe, autre) < jusque) {
                return true;
            }
        }
        return false;
    }

    /** Celle du manuel ; la seconde racine si la première n'est pas au-delà d'epsilon. */
    private double distance(Rayon rayon, Objet3D objet) {
        Sphere s = (Sphere) objet;
        Point P = rayon.getP();
        double t = Formule.MANUEL.distance(P, rayon.getV(), s.getCentre(), s.getRayon());
        if (epsilon == 0 || t > epsilon) {
            return t;
        }
        double reste = Formule.MANUEL.distance(P.add(rayon.getV().mul(epsilon)), rayon.getV(), s.getCentre(), s.getRayon());
        return reste + epsilon;
    }
}
