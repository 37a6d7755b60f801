package lancer.rapide;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import lancer.Constantes;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.precision.Intersection;

/**
 * Copie des sphères d'une scène dans un tableau de nombres, où chacune a un numéro, dans l'ordre de la scène. Une
 * sphère y prend 32 octets, la moitié d'une ligne de cache. Les autres objets sont à part, comme ceux d'une classe
 * dérivée de {@link Sphere} qui déclare la distance, le centre ou le rayon.
 */
final class Spheres {

    /** Nombres par sphère dans {@link #geometrie} : centre, rayon. */
    static final int PAS = 4;

    final int nombre;
    final double[] geometrie;
    /** La sphère de chaque numéro, et son rang dans la scène. */
    final Objet3D[] objets;
    final int[] rang;
    /** Les objets qui ne sont pas exactement des sphères, et leur rang dans la scène. */
    final Objet3D[] autres;
    final int[] rangAutres;

    /** Les méthodes dont cette copie tient lieu. */
    private static final List<String> COPIEES = Arrays.asList("getIntersectionDistance", "getCentre", "getRayon");

    private static final ClassValue<Boolean> SPHERIQUE = new ClassValue<Boolean>() {
        @Override
        protected Boolean computeValue(Class<?> classe) {
            Class<?> c = classe;
            while (c != Objet3D.class && c != Sphere.class
                    && Arrays.stream(c.getDeclaredMethods()).noneMatch(m -> COPIEES.contains(m.getName()))) {
                c = c.getSuperclass();
            }
            return c == Sphere.class;
        }
    };

    private Map<Objet3D, Integer> numeros;

    Spheres(List<Objet3D> scene) {
        int n = 0;
        for (Objet3D objet : scene) {
            if (estUneSphere(objet)) {
                n++;
            }
        }
        nombre = n;
        geometrie = new double[PAS * n];
        rang = new int[n];
        objets = new Objet3D[n];
        autres = new Objet3D[scene.size() - n];
        rangAutres = new int[autres.length];
        int k = 0;
        int a = 0;
        int r = 0;
        for (Objet3D objet : scene) {
            if (!estUneSphere(objet)) {
                autres[a] = objet;
                rangAutres[a++] = r++;
                continue;
            }
            Sphere s = (Sphere) objet;
            Point c = s.getCentre();
            geometrie[PAS * k] = c.x;
            geometrie[PAS * k + 1] = c.y;
            geometrie[PAS * k + 2] = c.z;
            geometrie[PAS * k + 3] = s.getRayon();
            rang[k] = r++;
            objets[k++] = objet;
        }
    }

    private static boolean estUneSphere(Objet3D objet) {
        return objet.getClass() == Sphere.class || SPHERIQUE.get(objet.getClass());
    }

    /** Dit si la sphère k a encore le centre et le rayon qui ont été copiés. */
    boolean estEnPlace(int k) {
        Sphere s = (Sphere) objets[k];
        Point c = s.getCentre();
        int g = PAS * k;
        return c.x == geometrie[g] && c.y == geometrie[g + 1] && c.z == geometrie[g + 2]
                && s.getRayon() == geometrie[g + 3];
    }

    /** Dit si toutes les sphères sont en place. */
    boolean sontEnPlace() {
        int k = 0;
        while (k < nombre && estEnPlace(k)) {
            k++;
        }
        return k == nombre;
    }

    /** Dit si la sphère k donne pour ce rayon, au bit près, la distance que donne sa copie. */
    boolean repond(int k, Point P, Vecteur V) {
        int g = PAS * k;
        double d = Intersection.distance(P.x, P.y, P.z, V.x, V.y, V.z, geometrie[g], geometrie[g + 1],
                geometrie[g + 2], geometrie[g + 3]);
        return Double.compare(d, objets[k].getIntersectionDistance(Rayon.dOmbre(P, V))) == 0;
    }

    int[] toutes() {
        int[] toutes = new int[nombre];
        for (int k = 0; k < nombre; k++) {
            toutes[k] = k;
        }
        return toutes;
    }

    /** Dit si le contact à {@code d} avec la sphère k précède celui à {@code distance} avec {@code autre}. */
    static boolean avant(double d, int k, double distance, int autre) {
        return d < distance || d == distance && d != Constantes.INFINI && k < autre;
    }

    /** Le numéro de cet objet, -1 si ce n'est pas une sphère. La table est construite à la première demande. */
    synchronized int numero(Objet3D objet) {
        if (!(objet instanceof Sphere)) {
            return -1;
        }
        if (numeros == null) {
            numeros = new IdentityHashMap<>(2 * nombre);
            for (int k = 0; k < nombre; k++) {
                numeros.put(objets[k], k);
            }
        }
        Integer k = numeros.get(objet);
        return k == null ? -1 : k;
    }
}
