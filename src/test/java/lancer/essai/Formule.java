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
        public double distance(double px, double py, double pz, double vx, double vy, double vz,
                double cx, double cy, double cz, double r) {
            double fx = px - cx;
            double fy = py - cy;
            double fz = pz - cz;
            double a = vx * vx + vy * vy + vz * vz;
            double b = 2 * (vx * fx + vy * fy + vz * fz);
            double c = fx * fx + fy * fy + fz * fz - r * r;
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
        public double distance(double px, double py, double pz, double vx, double vy, double vz,
                double cx, double cy, double cz, double r) {
            double fx = px - cx;
            double fy = py - cy;
            double fz = pz - cz;
            double a = vx * vx + vy * vy + vz * vz;
            double b = 2 * (vx * fx + vy * fy + vz * fz);
            double c = fx * fx + fy * fy + fz * fz - r * r;
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
        public double distance(double px, double py, double pz, double vx, double vy, double vz,
                double cx, double cy, double cz, double r) {
            double fx = cx - px;
            double fy = cy - py;
            double fz = cz - pz;
            double b = fx * vx + fy * vy + fz * vz;
            double lx = fx - b * vx;
            double ly = fy - b * vy;
            double lz = fz - b * vz;
            double h2 = r * r - (lx * lx + ly * ly + lz * lz);
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
        public double distance(double px, double py, double pz, double vx, double vy, double vz,
                double cx, double cy, double cz, double r) {
            double avance = Math.max(0, (cx - px) * vx + (cy - py) * vy + (cz - pz) * vz - r);
            return avance + MANUEL.distance(px + avance * vx, py + avance * vy, pz + avance * vz, vx, vy, vz, cx, cy, cz, r);
        }
    },

    /** La nôtre, telle que le programme l'appelle. */
    PROGRAMME {
        @Override
        public double distance(double px, double py, double pz, double vx, double vy, double vz,
                double cx, double cy, double cz, double r) {
            return Intersection.distance(px, py, pz, vx, vy, vz, cx, cy, cz, r);
        }
    },

    /** Le calcul compensé, que le programme ne fait que près d'une surface, fait toujours. Il n'est pas juste de loin : h² = b² − c. */
    COMPENSEE {
        @Override
        public double distance(double px, double py, double pz, double vx, double vy, double vz,
                double cx, double cy, double cz, double r) {
            return IntersectionCompensee.distance(px, py, pz, vx, vy, vz, cx, cy, cz, r);
        }
    },

    /** Celle du manuel, racines stables, chaque nombre étant la somme de deux doubles : P − C et tout ce qui le suit. */
    DEUX_DOUBLES {
        @Override
        public double distance(double px, double py, double pz, double vx, double vy, double vz,
                double cx, double cy, double cz, double r) {
            DeuxDoubles fx = DeuxDoubles.difference(cx, px);
            DeuxDoubles fy = DeuxDoubles.difference(cy, py);
            DeuxDoubles fz = DeuxDoubles.difference(cz, pz);
            DeuxDoubles a = DeuxDoubles.carre(vx).plus(DeuxDoubles.carre(vy)).plus(DeuxDoubles.carre(vz));
            DeuxDoubles b = fx.fois(vx).plus(fy.fois(vy)).plus(fz.fois(vz));
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

    public abstract double distance(double px, double py, double pz, double vx, double vy, double vz,
            double cx, double cy, double cz, double r);

    public final double distance(Point P, Vecteur V, Point C, double r) {
        return distance(P.x, P.y, P.z, V.x, V.y, V.z, C.x, C.y, C.z, r);
    }

    private static double premiere(double t1, double t2) {
        return t1 > 0 ? t1 : t2 > 0 ? t2 : Constantes.INFINI;
    }
}
