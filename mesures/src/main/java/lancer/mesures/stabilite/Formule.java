package lancer.mesures.stabilite;

import java.awt.Color;
import java.util.Locale;
import lancer.Constantes;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Style;
import lancer.precision.Intersection;
import lancer.precision.IntersectionCompensee;

/**
 * Méthodes de calcul de la plus petite distance positive d'un rayon à une sphère, avec leur nom et leur dessin sur une courbe. Les dix
 * nombres d'un cas se suivent à partir du rang k : départ P, direction V, centre C, rayon r.
 */
public enum Formule {

    /** Équation des manuels. Avec f = P − C, b² − 4ac soustrait deux nombres de l'ordre de |f|² pour un résultat de l'ordre de r². */
    MANUEL("manuel : b² − 4ac", Style.BLEU, FormeDePoint.CARRE, (n, k) -> {
        double fx = n[k] - n[k + 6];
        double fy = n[k + 1] - n[k + 7];
        double fz = n[k + 2] - n[k + 8];
        double a = n[k + 3] * n[k + 3] + n[k + 4] * n[k + 4] + n[k + 5] * n[k + 5];
        double b = 2 * (n[k + 3] * fx + n[k + 4] * fy + n[k + 5] * fz);
        double c = fx * fx + fy * fy + fz * fz - n[k + 9] * n[k + 9];
        double discriminant = b * b - 4 * a * c;
        if (discriminant < 0) {
            return Constantes.INFINI;
        }
        double racine = Math.sqrt(discriminant);
        return premiere((-b - racine) / (2 * a), (-b + racine) / (2 * a));
    }),

    /** Perpendiculaire du centre au rayon, calculée comme un vecteur : h² = r² − |f − bV|², puis les deux racines. */
    PERPENDICULAIRE("perpendiculaire : |f − bV|²", Style.VERT, FormeDePoint.POINTE, (n, k) -> {
        double fx = n[k + 6] - n[k];
        double fy = n[k + 7] - n[k + 1];
        double fz = n[k + 8] - n[k + 2];
        double b = fx * n[k + 3] + fy * n[k + 4] + fz * n[k + 5];
        double lx = fx - b * n[k + 3];
        double ly = fy - b * n[k + 4];
        double lz = fz - b * n[k + 5];
        double h2 = n[k + 9] * n[k + 9] - (lx * lx + ly * ly + lz * lz);
        return h2 < 0 ? Constantes.INFINI : premiere(b - Math.sqrt(h2), b + Math.sqrt(h2));
    }),

    /** Le calcul compensé, que le programme réserve aux départs près d'une surface. De loin, il est inexact : h² = b² − c. */
    COMPENSEE("toujours compensée", Style.POURPRE, FormeDePoint.CROIX, (n, k) -> IntersectionCompensee.distance(
            n[k], n[k + 1], n[k + 2], n[k + 3], n[k + 4], n[k + 5], n[k + 6], n[k + 7], n[k + 8], n[k + 9])),

    /** La méthode du programme. */
    PROGRAMME("le programme", Style.VERMILLON, FormeDePoint.ROND, (n, k) -> Intersection.distance(
            n[k], n[k + 1], n[k + 2], n[k + 3], n[k + 4], n[k + 5], n[k + 6], n[k + 7], n[k + 8], n[k + 9]));

    /** Nombre de nombres d'un cas. */
    static final int NOMBRES = 10;

    /** Nom dans la légende. */
    public final String nom;
    public final Color couleur;
    public final FormeDePoint forme;
    private final Calcul calcul;

    private interface Calcul {
        double distance(double[] n, int k);
    }

    Formule(String nom, Color couleur, FormeDePoint forme, Calcul calcul) {
        this.nom = nom;
        this.couleur = couleur;
        this.forme = forme;
        this.calcul = calcul;
    }

    /** Nom dans un fichier CSV. */
    public String cle() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** La distance, +∞ sans contact. */
    double distance(double[] n, int k) {
        return calcul.distance(n, k);
    }

    private static double premiere(double t1, double t2) {
        return t1 > 0 ? t1 : t2 > 0 ? t2 : Constantes.INFINI;
    }
}
