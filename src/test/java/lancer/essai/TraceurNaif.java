package lancer.essai;

import static lancer.essai.Triplets.dot;
import static lancer.essai.Triplets.moins;
import static lancer.essai.Triplets.plus;
import static lancer.essai.Triplets.t;
import static lancer.essai.Triplets.unite;

import java.util.List;
import lancer.Lampe;
import lancer.Sphere;

/** La formule du manuel, et les façons courantes de poser une question d'ombre ou de reflet. */
final class TraceurNaif extends TraceurPlat {

    /** Ce qui, entre un contact et une lampe, la cache. */
    enum Ombre {
        /** Tout ce que touche le rayon qui quitte le contact, l'objet éclairé compris. */
        SANS_EXCLURE,
        /** Tout autre objet, même derrière la lampe. */
        SANS_DISTANCE,
        /** Tout objet que la lampe voit le premier, si ce n'est celui qu'elle éclaire. */
        PREMIER_VU,
        /** Rien. */
        AUCUNE
    }

    private final Ombre ombre;
    private final double epsilon;

    /** @param epsilon une rencontre plus proche ne compte pas */
    TraceurNaif(List<Sphere> boules, List<Lampe> lampes, int cote, int reflets, Ombre ombre, double epsilon) {
        super(boules, lampes, cote, cote, reflets);
        this.ombre = ombre;
        this.epsilon = epsilon;
    }

    /** N'exclut rien : ce qui est à plus d'epsilon compte. */
    @Override
    protected Sphere premiere(double[] P, double[] V, Sphere sauf) {
        return super.premiere(P, V, null);
    }

    @Override
    protected Sphere cache(Lampe lampe, double[] X, Sphere boule) {
        double[] versLampe = moins(t(lampe.getPosition()), X);
        double[] L = unite(versLampe);
        Sphere vue;
        switch (ombre) {
            case SANS_EXCLURE:
                vue = premiere(X, L, null);
                return vue != null && distance(X, L, vue) < Math.sqrt(dot(versLampe, versLampe)) ? vue : null;
            case SANS_DISTANCE:
                return super.premiere(X, L, boule);
            case PREMIER_VU:
                vue = premiere(t(lampe.getPosition()), unite(moins(X, t(lampe.getPosition()))), null);
                return vue == boule ? null : boule;
            default:
                return null;
        }
    }

    /** Celle du manuel ; la seconde racine si la première n'est pas au-delà d'epsilon. */
    @Override
    protected double distance(double[] P, double[] V, Sphere boule) {
        double[] f = moins(t(boule.getCentre()), P);
        double d = Formule.MANUEL.distance(f, V, boule.getRayon());
        return epsilon == 0 || d > epsilon ? d : epsilon + Formule.MANUEL.distance(plus(f, -epsilon, V), V, boule.getRayon());
    }
}
