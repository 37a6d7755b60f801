package lancer.mesures.stabilite;

import java.math.BigDecimal;
import java.util.Random;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;

/** Un rayon et une sphère au hasard, et la réponse exacte. La même graine donne le même cas. */
final class Cas {

    /** Précision relative d'un double. */
    static final double U = 0x1p-53;

    /** P, V, C et r, à la suite. */
    final double[] nombres;

    /** Distance exacte, +∞ sans contact. Les nombres du cas sont pris comme exacts ; la direction est celle de deux points. */
    final double distance;

    /** La demi-corde, +∞ si la droite manque la sphère. Si elle est petite, une erreur sur les données a un grand effet. */
    private final double demiCorde;

    /** r − l, où l est la distance de la droite au centre ; négatif si la droite manque la sphère. */
    private final double enfoncement;

    Cas(Point P, Point vers, Point C, double r) {
        Vecteur V = new Rayon(P, vers).getV();
        nombres = new double[] {P.x, P.y, P.z, V.x, V.y, V.z, C.x, C.y, C.z, r};
        BigDecimal[] d = Decimaux.difference(exact(vers), exact(P), Decimaux.EXACT);
        BigDecimal[] f = Decimaux.difference(exact(C), exact(P), Decimaux.EXACT);
        BigDecimal norme2 = Decimaux.scalaire(d, d, Decimaux.EXACT);
        BigDecimal norme = Decimaux.racine(norme2);
        BigDecimal b = Decimaux.scalaire(f, d, Decimaux.EXACT).divide(norme, Decimaux.PRECIS);
        // le carré de la distance de la droite au centre, par un seul quotient, sans perte de chiffres
        BigDecimal l2 = Decimaux.scalaire(f, f, Decimaux.EXACT).multiply(norme2)
                .subtract(Decimaux.scalaire(f, d, Decimaux.EXACT).pow(2)).divide(norme2, Decimaux.PRECIS);
        BigDecimal h2 = new BigDecimal(r).pow(2).subtract(l2);
        BigDecimal h = Decimaux.racine(h2.max(BigDecimal.ZERO));
        double t = b.compareTo(h) > 0 ? b.subtract(h).doubleValue() : b.add(h).doubleValue();
        distance = h2.signum() < 0 || t <= 0 ? Double.POSITIVE_INFINITY : t;
        demiCorde = h2.signum() < 0 ? Double.POSITIVE_INFINITY : h.doubleValue();
        enfoncement = new BigDecimal(r).subtract(Decimaux.racine(l2)).doubleValue();
    }

    private static BigDecimal[] exact(Point p) {
        return new BigDecimal[] {new BigDecimal(p.x), new BigDecimal(p.y), new BigDecimal(p.z)};
    }

    /** Rayon qui part de loin, vers une sphère de rayon 1 ou à côté d'elle, à deux rayons au plus de son centre. */
    static Cas deLoin(Random hasard, double distance) {
        Point P = new Point().add(gauss(hasard));
        Vecteur vers = gauss(hasard).normalized();
        Point C = P.add(vers.mul(distance));
        return new Cas(P, C.add(cote(hasard, vers).mul(2 * hasard.nextDouble())), C, 1);
    }

    /** Rayon presque tangent à une sphère de rayon 1. @param marge 1 − l/r ; négative si le rayon manque la sphère */
    static Cas rasant(Random hasard, double distance, double marge) {
        Point C = new Point(hasard.nextDouble(), hasard.nextDouble(), hasard.nextDouble());
        Vecteur vers = gauss(hasard).normalized();
        Point P = C.sub(vers.mul(distance));
        double sinus = (1 - marge) / distance;
        double cosinus = Math.sqrt((1 - sinus) * (1 + sinus));
        // le rayon vise le pied de la perpendiculaire, proche de C, que l'arrondi déplace peu
        Vecteur pied = cote(hasard, vers).mul(cosinus).sub(vers.mul(sinus)).mul(1 - marge);
        return new Cas(P, C.add(pied), C, 1);
    }

    /** Rayon d'un œil à hauteur 1 environ au-dessus d'un sol, qu'il ne rase pas. */
    static Cas auSol(Random hasard, double rayon) {
        Point P = new Point(hasard.nextDouble(), hasard.nextDouble(), hasard.nextDouble());
        Vecteur bas = gauss(hasard).normalized();
        Point C = P.add(bas.mul(rayon + 0.5 + hasard.nextDouble()));
        double pente = 0.1 + 0.9 * hasard.nextDouble();
        Vecteur regard = bas.mul(pente).add(cote(hasard, bas).mul(Math.sqrt((1 - pente) * (1 + pente))));
        return new Cas(P, P.add(regard), C, rayon);
    }

    /** Rayon qui part près d'une surface, d'un côté ou de l'autre, dans une direction quelconque. @param hauteur en parts du rayon */
    static Cas pose(Random hasard, double hauteur) {
        Point C = new Point().add(gauss(hasard));
        double rayon = Math.pow(10, 1 - 2 * hasard.nextDouble());
        Point P = C.add(gauss(hasard).normalized().mul(rayon * (1 + (hasard.nextBoolean() ? hauteur : -hauteur))));
        return new Cas(P, P.add(gauss(hasard).normalized()), C, rayon);
    }

    /** Faux si l'arrondi de la direction suffit à changer un contact en absence de contact : aucune réponse n'est alors fausse. */
    boolean seJuge() {
        Vecteur f = new Vecteur(nombres[6] - nombres[0], nombres[7] - nombres[1], nombres[8] - nombres[2]);
        return Math.abs(enfoncement) >= Bilan.PROMESSE * U * (f.norme() + nombres[9]);
    }

    /** Dit si une méthode trouve un contact qui n'existe pas, en manque un, ou prend l'autre racine. */
    boolean malClasse(Formule formule) {
        double t = formule.distance(nombres, 0);
        if (Double.isInfinite(distance) || Double.isInfinite(t) || Double.isNaN(t)) {
            return t != distance;
        }
        return Math.abs(t - distance) > demiCorde;
    }

    /** |Δt| / t. */
    double erreurRelative(Formule formule) {
        return Math.abs(formule.distance(nombres, 0) - distance) / distance;
    }

    /** |Δt| en unités de κ u t = u (1 + r/h) t, l'effet inévitable de l'arrondi de la direction. */
    double erreurEnUnites(Formule formule) {
        return erreurRelative(formule) / (U * (1 + nombres[9] / demiCorde));
    }

    private static Vecteur gauss(Random hasard) {
        return new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
    }

    /** Une direction au hasard, perpendiculaire à {@code d}. */
    private static Vecteur cote(Random hasard, Vecteur d) {
        Vecteur w = gauss(hasard);
        return w.sub(d.mul(w.dot(d))).normalized();
    }
}
