package lancer.essai;

import lancer.Constantes;
import lancer.Point;
import lancer.Vecteur;
import lancer.precision.Intersection;
import lancer.precision.IntersectionCompensee;

/**
 * Des façons de calculer la distance d'un rayon à une sphère : celles que l'on trouve partout, celle du programme, et ce que coûterait
 * de calculer toujours plus finement : les tests montrent où chacune échoue.
 *
 * <p>Toutes reçoivent un départ P, une direction V « de longueur 1 », un centre C et un rayon r, et rendent la plus petite distance
 * strictement positive, +∞ si elles n'en trouvent pas.
 */
public enum Formule {

    /**
     * a t² + b t + c = 0, avec f = P − C, a = V·V, b = 2 V·f, c = f·f − r². Le discriminant b² − 4ac soustrait deux nombres de l'ordre
     * de |f|² pour en trouver un de l'ordre de r².
     */
    MANUEL {
        @Override
        public double distance(Point P, Vecteur V, Point C, double r) {
            Vecteur f = P.sub(C);
            double a = V.dot(V);
            double b = 2 * V.dot(f);
            double c = f.dot(f) - r * r;
            double discriminant = b * b - 4 * a * c;
            if (discriminant < 0) {
                return Constantes.INFINI;
            }
            double racine = Math.sqrt(discriminant);
            return premiere((-b - racine) / (2 * a), (-b + racine) / (2 * a));
        }
    },

    /** Le même discriminant, mais la racine q = −(b + signe(b)√Δ)/2 puis t = q/a ou c/q : rien ne s'y soustrait… après Δ. */
    RACINES {
        @Override
        public double distance(Point P, Vecteur V, Point C, double r) {
            Vecteur f = P.sub(C);
            double a = V.dot(V);
            double b = 2 * V.dot(f);
            double c = f.dot(f) - r * r;
            double discriminant = b * b - 4 * a * c;
            if (discriminant < 0) {
                return Constantes.INFINI;
            }
            double q = -(b + Math.copySign(Math.sqrt(discriminant), b)) / 2;
            return premiere(Math.min(q / a, c / q), Math.max(q / a, c / q));
        }
    },

    /** La perpendiculaire du centre au rayon, calculée comme un vecteur : h² = r² − |f − bV|², puis les racines telles quelles. */
    PERPENDICULAIRE {
        @Override
        public double distance(Point P, Vecteur V, Point C, double r) {
            Vecteur f = C.sub(P);
            double b = f.dot(V);
            Vecteur l = f.sub(V.mul(b));
            double h2 = r * r - l.dot(l);
            if (h2 < 0) {
                return Constantes.INFINI;
            }
            double h = Math.sqrt(h2);
            return premiere(b - h, b + h);
        }
    },

    /** Le manuel, une fois le départ avancé jusque près de la sphère (Wald, Ray Tracing Gems II, chapitre 34). */
    REPRISE {
        @Override
        public double distance(Point P, Vecteur V, Point C, double r) {
            double avance = Math.max(0, C.sub(P).dot(V) - r);
            return avance + MANUEL.distance(P.add(avance, V), V, C, r);
        }
    },

    /** La nôtre, telle que le programme l'appelle. */
    PROGRAMME {
        @Override
        public double distance(Point P, Vecteur V, Point C, double r) {
            return Intersection.distance(P.x, P.y, P.z, V.x, V.y, V.z, C.x, C.y, C.z, r);
        }
    },

    /** Le calcul compensé, que le programme ne fait que près d'une surface, fait toujours. Il n'est pas juste de loin : h² = b² − c. */
    COMPENSEE {
        @Override
        public double distance(Point P, Vecteur V, Point C, double r) {
            return IntersectionCompensee.distance(P.x, P.y, P.z, V.x, V.y, V.z, C.x, C.y, C.z, r);
        }
    },

    /** Celle du manuel, racines stables, chaque nombre étant la somme de deux doubles : P − C et tout ce qui le suit. */
    DEUX_DOUBLES {
        @Override
        public double distance(Point P, Vecteur V, Point C, double r) {
            DeuxDoubles fx = DeuxDoubles.difference(C.x, P.x);
            DeuxDoubles fy = DeuxDoubles.difference(C.y, P.y);
            DeuxDoubles fz = DeuxDoubles.difference(C.z, P.z);
            DeuxDoubles a = DeuxDoubles.carre(V.x).plus(DeuxDoubles.carre(V.y)).plus(DeuxDoubles.carre(V.z));
            DeuxDoubles b = fx.fois(V.x).plus(fy.fois(V.y)).plus(fz.fois(V.z));
            DeuxDoubles c = fx.fois(fx).plus(fy.fois(fy)).plus(fz.fois(fz)).moins(DeuxDoubles.carre(r));
            DeuxDoubles discriminant = b.fois(b).moins(a.fois(c));
            if (discriminant.haut < 0) {
                return Constantes.INFINI;
            }
            double racine = Math.sqrt(discriminant.haut);
            // la racine n'est prise qu'en doubles : sa part de l'erreur est celle d'un arrondi de h ; V n'est de longueur 1 qu'à u près
            double longueur = Math.sqrt(a.haut);
            if (c.haut > 0) {
                return b.haut > 0 ? c.haut / (b.haut + racine) * longueur : Constantes.INFINI;
            }
            return b.haut > 0 ? (b.haut + racine) / longueur : c.haut < 0 ? c.haut / (b.haut - racine) * longueur : Constantes.INFINI;
        }
    };

    public abstract double distance(Point P, Vecteur V, Point C, double r);

    private static double premiere(double t1, double t2) {
        return t1 > 0 ? t1 : t2 > 0 ? t2 : Constantes.INFINI;
    }
}
