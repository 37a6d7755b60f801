package lancer.essai;

import static lancer.essai.Triplets.dot;
import static lancer.essai.Triplets.moins;
import static lancer.essai.Triplets.plus;
import static lancer.essai.Triplets.t;

import lancer.Point;
import lancer.Vecteur;

/**
 * Des façons de calculer la distance d'un rayon à une sphère, celles que l'on trouve partout : les tests montrent où chacune échoue. Leur
 * arithmétique est la leur, et ne change pas avec le programme.
 */
public enum Formule {

    /**
     * a t² + b t + c = 0, a = V·V, b = −2 V·f, c = f·f − r². Le discriminant b² − 4ac soustrait deux nombres de l'ordre de |f|² pour en
     * trouver un de l'ordre de r².
     */
    MANUEL((f, V, r) -> {
        double a = dot(V, V);
        double b = -2 * dot(V, f);
        double racine = Math.sqrt(b * b - 4 * a * (dot(f, f) - r * r));
        return premiere((-b - racine) / (2 * a), (-b + racine) / (2 * a));
    }),

    /** Le même discriminant, mais la racine q = −(b + signe(b)√Δ)/2 puis t = q/a ou c/q : rien ne s'y soustrait… après Δ. */
    RACINES((f, V, r) -> {
        double a = dot(V, V);
        double b = -2 * dot(V, f);
        double c = dot(f, f) - r * r;
        double q = -(b + Math.copySign(Math.sqrt(b * b - 4 * a * c), b)) / 2;
        return premiere(Math.min(q / a, c / q), Math.max(q / a, c / q));
    }),

    /** La perpendiculaire du centre au rayon, calculée comme un vecteur : h² = r² − |f − bV|², puis les racines telles quelles. */
    PERPENDICULAIRE((f, V, r) -> {
        double b = dot(f, V);
        double h = demiCorde(f, V, r);
        return premiere(b - h, b + h);
    }),

    /**
     * La perpendiculaire, et les racines sans soustraction : juste de loin, mais C − P y est arrondi d'abord, et |C − P|² − r² perd
     * autant de chiffres que P est près de la surface.
     */
    EN_DOUBLES((f, V, r) -> {
        double b = dot(f, V);
        double h = demiCorde(f, V, r);
        double c = dot(f, f) - r * r;
        double entree = b > 0 ? c / (b + h) : Double.NaN;
        return c > 0 ? premiere(entree, entree) : premiere(b > 0 ? b + h : c / (b - h), Double.NaN);
    }),

    /**
     * Le manuel, une fois le départ avancé jusque près de la sphère (Wald, Ray Tracing Gems II, chapitre 34) ; d'un sol, il n'y a rien à
     * avancer.
     */
    REPRISE((f, V, r) -> {
        double avance = Math.max(0, dot(f, V) - r);
        return avance + MANUEL.distance(plus(f, -avance, V), V, r);
    });

    private interface Calcul {
        double distance(double[] f, double[] V, double r);
    }

    private final Calcul calcul;

    Formule(Calcul calcul) {
        this.calcul = calcul;
    }

    /** @param f du départ au centre @param V « de longueur 1 » @return la plus petite distance positive, +∞ s'il n'y en a pas */
    double distance(double[] f, double[] V, double r) {
        return calcul.distance(f, V, r);
    }

    public double distance(Point P, Vecteur V, Point C, double r) {
        return distance(moins(t(C), t(P)), t(V), r);
    }

    /** NaN si la droite ne touche pas la sphère. */
    private static double demiCorde(double[] f, double[] V, double r) {
        double[] l = plus(f, -dot(f, V), V);
        return Math.sqrt(r * r - dot(l, l));
    }

    private static double premiere(double t1, double t2) {
        return t1 > 0 ? t1 : t2 > 0 ? t2 : Double.POSITIVE_INFINITY;
    }
}
