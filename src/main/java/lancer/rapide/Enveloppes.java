package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;
import lancer.contrat.Recherche;

/**
 * Les enveloppes des objets d'une scène, copiées et élargies. Un objet sans enveloppe, ou dont l'enveloppe est plus
 * grande que {@value #LONGUEUR_MAX}, est libre : il est proposé à tous les rayons.
 *
 * <p>Une distance calculée par {@link Sphere} est exacte pour une sphère dont le rayon diffère d'au plus 16 u (|C − P|
 * + r), avec u = 2^-53. L'élargissement, de {@value #MARGE} fois les coordonnées, couvre cette erreur près de l'objet.
 * Loin de lui, une marge proportionnelle à |C − P| s'y ajoute.
 */
final class Enveloppes {

    /** Nombres par objet dans {@link #geometrie} : centre, rayon ; le rayon d'un objet libre est NaN. */
    static final int PAS = 4;

    static final double MARGE = 1e-9;

    /** Au-delà, le produit de deux longueurs déborderait. */
    static final double LONGUEUR_MAX = 1e120;

    /** Un géant a plus de {@code ECHELLE_DES_GEANTS} fois le rayon de l'enveloppe de ce rang : il y en a peu. */
    private static final int RANG_DES_GEANTS = 9;
    private static final double ECHELLE_DES_GEANTS = 8;

    final Objet3D[] objets;
    final double[] geometrie;

    /** Rangs, dans la scène, des objets à examiner d'abord, géants ou libres, de tous les autres, et de tous. */
    final int[] dAbord;
    final int[] petits;
    final int[] tous;

    Enveloppes(List<Objet3D> scene) {
        objets = scene.toArray(new Objet3D[0]);
        geometrie = copier();
        double geant = geant();
        tous = new int[objets.length];
        int avant = 0;
        int apres = tous.length;
        for (int k = 0; k < tous.length; k++) {
            // NaN n'est pas petit
            if (geometrie[PAS * k + 3] <= geant) {
                tous[avant++] = k;
            } else {
                tous[--apres] = k;
            }
        }
        petits = Arrays.copyOf(tous, avant);
        dAbord = Arrays.copyOfRange(tous, avant, tous.length);
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

    /** Le rayon au-delà duquel une enveloppe est un géant. */
    private double geant() {
        double[] rayons = new double[objets.length];
        for (int k = 0; k < rayons.length; k++) {
            double r = geometrie[PAS * k + 3];
            rayons[k] = r >= 0 ? r : 0;
        }
        Arrays.sort(rayons);
        double neuvieme = rayons.length < RANG_DES_GEANTS ? 0 : rayons[rayons.length - RANG_DES_GEANTS];
        return neuvieme == 0 ? Double.POSITIVE_INFINITY : ECHELLE_DES_GEANTS * neuvieme;
    }

    /** Dit si aucune enveloppe n'a changé depuis la copie. */
    boolean sontEnPlace() {
        return Arrays.equals(geometrie, copier());
    }

    static double plusGrande(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }
}
