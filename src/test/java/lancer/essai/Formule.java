package lancer.essai;

import lancer.Constantes;
import lancer.Point;
import lancer.Vecteur;
import lancer.precision.Intersection;

/**
 * Des façons de calculer la distance d'un rayon à une sphère, celles que l'on trouve partout et celle du programme : les tests montrent
 * où chacune échoue.
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

    /**
     * La perpendiculaire, et les racines sans soustraction : juste de loin, mais C − P y est arrondi d'abord, et |C − P|² − r² perd
     * autant de chiffres que P est près de la surface.
     */
    EN_DOUBLES {
        @Override
        public double distance(Point P, Vecteur V, Point C, double r) {
            Vecteur f = C.sub(P);
            double b = f.dot(V);
            double h2 = r * r - f.sub(V.mul(b)).norme2();
            if (!(h2 >= 0)) {
                return Constantes.INFINI;
            }
            double c = f.norme2() - r * r;
            if (c > 0) {
                return b > 0 ? c / (b + Math.sqrt(h2)) : Constantes.INFINI;
            }
            return premiere(b > 0 ? b + Math.sqrt(h2) : c / (b - Math.sqrt(h2)), Constantes.INFINI);
        }
    },

    /**
     * Le manuel, une fois le départ avancé jusque près de la sphère (Wald, Ray Tracing Gems II, chapitre 34) ; d'un sol, il n'y a rien à
     * avancer.
     */
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
    };

    public abstract double distance(Point P, Vecteur V, Point C, double r);

    private static double premiere(double t1, double t2) {
        return t1 > 0 ? t1 : t2 > 0 ? t2 : Constantes.INFINI;
    }
}
