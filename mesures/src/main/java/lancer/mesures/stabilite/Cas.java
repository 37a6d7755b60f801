package lancer.mesures.stabilite;

import java.util.Random;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.essai.Exact;
import lancer.essai.Formule;

/** Un rayon et une sphère, tirés au sort, et la réponse exacte. Une même graine donne les mêmes. */
public final class Cas {

    /** Précision relative d'un double. */
    static final double U = 0x1p-53;

    /** Ce que promet le programme, en unités de l'erreur inévitable. */
    static final double K = 8;

    private final Point P;
    private final Vecteur V;
    private final Point C;
    private final double r;
    final Exact exacte;

    private Cas(Point P, Point vers, Point C, double r) {
        this.P = P;
        this.V = new Rayon(P, vers).getV();
        this.C = C;
        this.r = r;
        this.exacte = new Exact(P, vers, C, r);
    }

    /** De loin, vers une sphère de rayon 1 ou à côté d'elle, jusqu'à deux rayons de son centre. */
    static Cas deLoin(Random hasard, double distance) {
        Point P = new Point().add(gauss(hasard));
        Vecteur vers = gauss(hasard).normalized();
        Point C = P.add(vers.mul(distance));
        return new Cas(P, C.add(cote(hasard, vers).mul(2 * hasard.nextDouble())), C, 1);
    }

    /** Au ras d'une sphère de rayon 1. @param marge 1 − l/r : ce qui sépare le rayon de la tangente ; négatif, il passe à côté */
    static Cas rasant(Random hasard, double distance, double marge) {
        Point C = new Point(hasard.nextDouble(), hasard.nextDouble(), hasard.nextDouble());
        Vecteur vers = gauss(hasard).normalized();
        Point P = C.sub(vers.mul(distance));
        double sinus = (1 - marge) / distance;
        double cosinus = Math.sqrt((1 - sinus) * (1 + sinus));
        // le pied de la perpendiculaire : un point voisin de C, que son arrondi déplace aussi peu que possible
        Vecteur pied = cote(hasard, vers).mul(cosinus).sub(vers.mul(sinus)).mul(1 - marge);
        return new Cas(P, C.add(pied), C, 1);
    }

    /** D'un œil à hauteur 1, à peu près, au-dessus d'un sol, qu'il regarde sans le raser. */
    static Cas auSol(Random hasard, double rayon) {
        Point P = new Point(hasard.nextDouble(), hasard.nextDouble(), hasard.nextDouble());
        Vecteur bas = gauss(hasard).normalized();
        Point C = P.add(bas.mul(rayon + 0.5 + hasard.nextDouble()));
        double pente = 0.1 + 0.9 * hasard.nextDouble();
        Vecteur regard = bas.mul(pente).add(cote(hasard, bas).mul(Math.sqrt((1 - pente) * (1 + pente))));
        return new Cas(P, P.add(regard), C, rayon);
    }

    /** D'un point posé au-dessus ou au-dessous d'une surface, dans une direction quelconque. @param hauteur en parts du rayon */
    static Cas pose(Random hasard, double hauteur) {
        Point C = new Point().add(gauss(hasard));
        double rayon = Math.pow(10, 1 - 2 * hasard.nextDouble());
        Point P = C.add(gauss(hasard).normalized().mul(rayon * (1 + (hasard.nextBoolean() ? hauteur : -hauteur))));
        return new Cas(P, P.add(gauss(hasard).normalized()), C, rayon);
    }

    /** Faux si l'arrondi de la direction suffit à faire toucher ou manquer la sphère : les deux réponses se valent. */
    boolean seJuge() {
        return Math.abs(exacte.enfoncement) >= K * U * (new Vecteur(P, C).norme() + r);
    }

    /** Vrai si une méthode touche ce qu'il faut manquer, ou l'inverse, ou prend une racine pour l'autre. */
    public boolean malClasse(Formule formule) {
        double t = formule.distance(P, V, C, r);
        if (Double.isInfinite(exacte.distance) || Double.isInfinite(t) || Double.isNaN(t)) {
            return t != exacte.distance;
        }
        return Math.abs(t - exacte.distance) > exacte.demiCorde;
    }

    /** |Δt| / t. */
    public double erreurRelative(Formule formule) {
        return Math.abs(formule.distance(P, V, C, r) - exacte.distance) / exacte.distance;
    }

    /** |Δt| en unités de κ u t = u (1 + r/h) t : ce que l'arrondi de la direction, que personne n'évite, change à la réponse. */
    double erreurEnUnites(Formule formule) {
        return erreurRelative(formule) / (U * (1 + r / exacte.demiCorde));
    }

    /** P, V, C et r, à la suite à partir de {@code k}. */
    public void copier(double[] nombres, int k) {
        double[] siens = {P.x, P.y, P.z, V.x, V.y, V.z, C.x, C.y, C.z, r};
        System.arraycopy(siens, 0, nombres, k, siens.length);
    }

    private static Vecteur gauss(Random hasard) {
        return new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
    }

    /** Une direction perpendiculaire à celle-ci. */
    private static Vecteur cote(Random hasard, Vecteur d) {
        Vecteur w = gauss(hasard);
        return w.sub(d.mul(w.dot(d))).normalized();
    }
}
