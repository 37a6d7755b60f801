package lancer.mesures.stabilite;

import java.awt.Color;
import lancer.Constantes;
import lancer.Point;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Style;

/** Des façons de calculer la distance d'un rayon à une sphère : celles que l'on trouve partout, puis celle du programme. */
enum Formule {

    /** La projection du centre sur le rayon, puis Pythagore : deux grands carrés s'y soustraient. */
    GEOMETRIQUE("geometrique", "géométrique : |f|² − b²", Style.ORANGE, FormeDePoint.TRIANGLE) {
        @Override
        double distance(Point P, Vecteur V, Point C, double r) {
            Vecteur f = new Vecteur(P, C);
            double projection = f.dot(V);
            double l2 = f.dot(f) - projection * projection;
            if (l2 > r * r) {
                return Constantes.INFINI;
            }
            double h = Math.sqrt(r * r - l2);
            return premiere(projection - h, projection + h);
        }
    },

    /** Le discriminant du manuel, puis des racines où rien ne se soustrait : q/a et c/q. */
    RACINES("racines", "b² − 4ac, racines stables", Style.CIEL, FormeDePoint.LOSANGE) {
        @Override
        double distance(Point P, Vecteur V, Point C, double r) {
            Vecteur f = new Vecteur(C, P);
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

    /** a t² + b t + c = 0, son discriminant b² − 4ac, et ses deux racines. */
    MANUEL("manuel", "manuel : b² − 4ac", Style.BLEU, FormeDePoint.CARRE) {
        @Override
        double distance(Point P, Vecteur V, Point C, double r) {
            Vecteur f = new Vecteur(C, P);
            double a = V.dot(V);
            double b = 2 * V.dot(f);
            double discriminant = b * b - 4 * a * (f.dot(f) - r * r);
            if (discriminant < 0) {
                return Constantes.INFINI;
            }
            double racine = Math.sqrt(discriminant);
            return premiere((-b - racine) / (2 * a), (-b + racine) / (2 * a));
        }
    },

    /** La perpendiculaire du centre au rayon, calculée comme un vecteur, puis les racines telles quelles. */
    PERPENDICULAIRE("perpendiculaire", "perpendiculaire : |f − bV|²", Style.VERT, FormeDePoint.POINTE) {
        @Override
        double distance(Point P, Vecteur V, Point C, double r) {
            Vecteur f = new Vecteur(P, C);
            double b = f.dot(V);
            double h2 = r * r - f.sub(V.mul(b)).norme2();
            if (h2 < 0) {
                return Constantes.INFINI;
            }
            double h = Math.sqrt(h2);
            return premiere(b - h, b + h);
        }
    },

    /** La nôtre, telle que le programme l'appelle. */
    PROGRAMME("programme", "le programme", Style.VERMILLON, FormeDePoint.ROND) {
        @Override
        double distance(Point P, Vecteur V, Point C, double r) {
            return Sphere.distance(P.x, P.y, P.z, V.x, V.y, V.z, C.x, C.y, C.z, r);
        }
    };

    /** Dans le CSV. */
    final String cle;

    /** Dans la légende. */
    final String nom;
    final Color couleur;
    final FormeDePoint forme;

    Formule(String cle, String nom, Color couleur, FormeDePoint forme) {
        this.cle = cle;
        this.nom = nom;
        this.couleur = couleur;
        this.forme = forme;
    }

    /** @return la plus petite distance strictement positive, +∞ si elle n'en trouve pas */
    abstract double distance(Point P, Vecteur V, Point C, double r);

    private static double premiere(double t1, double t2) {
        return t1 > 0 ? t1 : t2 > 0 ? t2 : Constantes.INFINI;
    }
}
