package lancer.scene;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;

/** Les sphères confondues avec une autre : on les toucherait à une distance nulle, à un arrondi près. */
public final class Jumelles {

    private Jumelles() {
    }

    /** Les objets, dans le même ordre, sans les sphères de mêmes centre et rayon qu'une précédente. */
    public static List<Objet3D> sans(List<? extends Objet3D> objets) {
        List<Objet3D> gardes = new ArrayList<>(objets.size());
        Set<Geometrie> vues = new HashSet<>(2 * objets.size());
        for (Objet3D objet : objets) {
            if (objet.getClass() != Sphere.class || vues.add(new Geometrie((Sphere) objet))) {
                gardes.add(objet);
            }
        }
        return gardes;
    }

    /**
     * Centre et rayon. L'ordre est pour la table : des centres choisis pour avoir tous le même code y coûteraient sinon
     * le carré de leur nombre.
     */
    private static final class Geometrie implements Comparable<Geometrie> {

        private final Sphere sphere;

        Geometrie(Sphere sphere) {
            this.sphere = sphere;
        }

        @Override
        public int hashCode() {
            Point c = sphere.getCentre();
            return Double.hashCode(c.x + 31 * (c.y + 31 * (c.z + 31 * sphere.getRayon())));
        }

        @Override
        public boolean equals(Object autre) {
            return autre instanceof Geometrie && compareTo((Geometrie) autre) == 0;
        }

        @Override
        public int compareTo(Geometrie autre) {
            Point c = sphere.getCentre();
            Point d = autre.sphere.getCentre();
            // + 0.0 : −0.0 et 0.0 sont la même position
            int x = Double.compare(c.x + 0.0, d.x + 0.0);
            int y = x != 0 ? x : Double.compare(c.y + 0.0, d.y + 0.0);
            int z = y != 0 ? y : Double.compare(c.z + 0.0, d.z + 0.0);
            return z != 0 ? z : Double.compare(sphere.getRayon(), autre.sphere.getRayon());
        }
    }
}
