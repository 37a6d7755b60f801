package lancer.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;
import lancer.contrat.Recherche;

/** Les sphères confondues : un rayon qui part de l'une toucherait l'autre à une distance presque nulle. */
public final class SpheresConfondues implements Comparator<Sphere> {

    private SpheresConfondues() {
    }

    /** Les objets, dans le même ordre, sans les sphères de mêmes centre et rayon qu'une précédente. */
    public static List<Objet3D> sans(List<? extends Objet3D> objets) {
        List<Objet3D> gardes = new ArrayList<>(objets.size());
        Set<Sphere> vues = new TreeSet<>(new SpheresConfondues());
        for (Objet3D objet : objets) {
            Recherche.obeir();
            if (objet.getClass() != Sphere.class || vues.add((Sphere) objet)) {
                gardes.add(objet);
            }
        }
        return gardes;
    }

    @Override
    public int compare(Sphere une, Sphere autre) {
        Point c = une.getCentre();
        Point d = autre.getCentre();
        // + 0.0 : −0.0 et 0.0 désignent la même position
        int x = Double.compare(c.x + 0.0, d.x + 0.0);
        int y = x != 0 ? x : Double.compare(c.y + 0.0, d.y + 0.0);
        int z = y != 0 ? y : Double.compare(c.z + 0.0, d.z + 0.0);
        return z != 0 ? z : Double.compare(une.getRayon(), autre.getRayon());
    }
}
