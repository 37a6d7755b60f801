package lancer.mesures.stabilite;

import java.util.Locale;
import java.util.function.ToDoubleFunction;
import lancer.Constantes;
import lancer.precision.Intersection;

/**
 * Méthodes de calcul de la plus petite distance positive d'un rayon à une sphère. Les dix nombres d'un cas se suivent : départ P,
 * direction V, centre C, rayon r.
 */
public enum Formule {

    /** Équation des manuels. Avec f = P − C, b² − 4ac soustrait deux nombres de l'ordre de |f|² pour un résultat de l'ordre de r². */
    MANUEL("manuel : b² − 4ac", n -> {
        double fx = n[0] - n[6];
        double fy = n[1] - n[7];
        double fz = n[2] - n[8];
        double a = n[3] * n[3] + n[4] * n[4] + n[5] * n[5];
        double b = 2 * (n[3] * fx + n[4] * fy + n[5] * fz);
        double c = fx * fx + fy * fy + fz * fz - n[9] * n[9];
        double discriminant = b * b - 4 * a * c;
        if (discriminant < 0) {
            return Constantes.INFINI;
        }
        double racine = Math.sqrt(discriminant);
        return premiere((-b - racine) / (2 * a), (-b + racine) / (2 * a));
    }),

    /** Perpendiculaire du centre au rayon, calculée comme un vecteur : h² = r² − |f − bV|², puis les deux racines. */
    PERPENDICULAIRE("perpendiculaire : |f − bV|²", n -> {
        double fx = n[6] - n[0];
        double fy = n[7] - n[1];
        double fz = n[8] - n[2];
        double b = fx * n[3] + fy * n[4] + fz * n[5];
        double lx = fx - b * n[3];
        double ly = fy - b * n[4];
        double lz = fz - b * n[5];
        double h2 = n[9] * n[9] - (lx * lx + ly * ly + lz * lz);
        return h2 < 0 ? Constantes.INFINI : premiere(b - Math.sqrt(h2), b + Math.sqrt(h2));
    }),

    /** La méthode du programme. */
    PROGRAMME("le programme", n -> Intersection.distance(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]));

    /** Nom dans la légende. */
    final String nom;
    private final ToDoubleFunction<double[]> calcul;

    Formule(String nom, ToDoubleFunction<double[]> calcul) {
        this.nom = nom;
        this.calcul = calcul;
    }

    /** Nom dans un fichier CSV. */
    String cle() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** La distance ; +∞ sans contact. */
    double distance(double[] cas) {
        return calcul.applyAsDouble(cas);
    }

    private static double premiere(double t1, double t2) {
        double seconde = t2 > 0 ? t2 : Constantes.INFINI;
        return t1 > 0 ? t1 : seconde;
    }
}
