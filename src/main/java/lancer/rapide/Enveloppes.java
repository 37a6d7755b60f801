package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;
import lancer.contrat.Recherche;

/**
 * Les enveloppes des objets d'une scène, copiées et élargies. Un objet sans enveloppe, ou dont l'enveloppe est plus
 * grande que {@value #LONGUEUR_MAX}, est libre : tous les rayons lui sont soumis.
 *
 * <p>Une distance calculée par {@link Sphere} est exacte pour une sphère dont le rayon diffère d'au plus 16 u (|C − P|
 * + r), avec u = 2^-53. L'élargissement, de {@value #MARGE} fois les coordonnées, couvre cette erreur près de l'objet.
 * Loin de lui, chaque structure ajoute une marge proportionnelle aux coordonnées de P.
 */
final class Enveloppes {

    /** Nombres par objet dans {@link #geometrie} : centre, rayon ; le rayon d'un objet libre est NaN. */
    static final int PAS = 4;

    static final double MARGE = 1e-9;

    /** Au-delà, le produit de deux longueurs déborderait. */
    static final double LONGUEUR_MAX = 1e120;

    final Objet3D[] objets;
    final double[] geometrie;

    /** Rangs, dans la scène, des objets qui ont une enveloppe, et des objets libres. */
    final int[] bornes;
    final int[] libres;

    Enveloppes(List<Objet3D> scene) {
        objets = scene.toArray(new Objet3D[0]);
        geometrie = copier();
        int[] rangs = new int[objets.length];
        int avant = 0;
        int apres = rangs.length;
        for (int k = 0; k < rangs.length; k++) {
            if (geometrie[PAS * k + 3] >= 0) {
                rangs[avant++] = k;
            } else {
                rangs[--apres] = k;
            }
        }
        bornes = Arrays.copyOf(rangs, avant);
        libres = Arrays.copyOfRange(rangs, avant, rangs.length);
    }

    private double[] copier() {
        double[] g = new double[PAS * objets.length];
        for (int k = 0; k < objets.length; k++) {
            Recherche.obeir();
            Sphere enveloppe = objets[k].getEnveloppe();
            g[PAS * k + 3] = Double.NaN;
            if (enveloppe != null) {
                Point c = enveloppe.getCentre();
                double r = enveloppe.getRayon();
                double loin = Math.max(plusGrande(c.x, c.y, c.z), r);
                g[PAS * k] = c.x;
                g[PAS * k + 1] = c.y;
                g[PAS * k + 2] = c.z;
                g[PAS * k + 3] = loin < LONGUEUR_MAX ? r + MARGE * loin : Double.NaN;
            }
        }
        return g;
    }

    /** Dit si aucune enveloppe n'a changé depuis la copie. */
    boolean sontEnPlace() {
        return Arrays.equals(geometrie, copier());
    }

    static double plusGrande(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    /** Le rang de celui-ci dans ce tableau, cherché à partir d'un rang ; s'il n'y est pas, ce rang. */
    static int trouver(Object celui, Object[] tableau, int depuis) {
        int rang = depuis;
        for (int k = 0; k < tableau.length && tableau[rang] != celui; k++) {
            rang = rang + 1 < tableau.length ? rang + 1 : 0;
        }
        return rang;
    }

    /** Dit si cette direction est de longueur 1, comme toutes les structures le supposent. */
    static boolean estUnitaire(double x, double y, double z) {
        // la négation de l'appelant refuse aussi NaN
        return Math.abs(x * x + y * y + z * z - 1) < 1e-14;
    }
}
