package lancer.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;

/** Les sphères confondues avec une autre : on les toucherait à une distance nulle, à un arrondi près. */
public final class Jumelles implements Comparator<Sphere> {

    private Jumelles() {
    }

    /** Les objets, dans le même ordre, sans les sphères de mêmes centre et rayon qu'une précédente. */
    public static List<Objet3D> sans(List<? extends Objet3D> objets) {
        List<Sphere> spheres = new ArrayList<>(objets.size());
        for (Objet3D objet : objets) {
            if (objet.getClass() == Sphere.class) {
                spheres.add((Sphere) objet);
            }
        }
        Comparator<Sphere> ordre = new Jumelles();
        spheres.sort(ordre);
        Set<Objet3D> enTrop = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int k = 1; k < spheres.size(); k++) {
            if (ordre.compare(spheres.get(k - 1), spheres.get(k)) == 0) {
                enTrop.add(spheres.get(k));
            }
        }
        List<Objet3D> gardes = new ArrayList<>(objets);
        gardes.removeAll(enTrop);
        return gardes;
    }

    /** Range par centre, puis par rayon. */
    @Override
    public int compare(Sphere une, Sphere autre) {
        Point c = une.getCentre();
        Point d = autre.getCentre();
        // + 0.0 : −0.0 et 0.0 sont la même position
        int x = Double.compare(c.x + 0.0, d.x + 0.0);
        int y = x != 0 ? x : Double.compare(c.y + 0.0, d.y + 0.0);
        int z = y != 0 ? y : Double.compare(c.z + 0.0, d.z + 0.0);
        return z != 0 ? z : Double.compare(une.getRayon(), autre.getRayon());
    }
}
