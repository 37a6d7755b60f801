package lancer.essai;

import java.util.List;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/** Les boucles du cours, et les façons courantes d'y poser une question d'ombre ou de reflet. */
public final class RechercheNaive implements Recherche {

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

    private final List<? extends Objet3D> objets;
    private final Ombre ombre;
    private final double epsilon;

    /** @param epsilon une rencontre plus proche ne compte pas */
    public RechercheNaive(List<? extends Objet3D> objets, Ombre ombre, double epsilon) {
        this.objets = objets;
        this.ombre = ombre;
        this.epsilon = epsilon;
    }

    /** N'exclut rien : ce qui est à plus d'epsilon compte. */
    @Override
    public void plusProche(Rayon incident, Objet3D saufLui) {
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

    @Override
    public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
        Point contact = P.add(distance, V);
        if (ombre == Ombre.PREMIER_DU_MANUEL) {
            Rayon deLaLampe = new Rayon(lampe.getPosition(), contact);
            plusProche(deLaLampe, null);
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

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return this;
    }
}
