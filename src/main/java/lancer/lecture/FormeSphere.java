package lancer.lecture;

import lancer.Objet3D;
import lancer.Sphere;
import lancer.contrat.Forme;
import lancer.contrat.Section;

/** Les sections {@code [Sphere]}. */
final class FormeSphere implements Forme {

    @Override
    public String getSection() {
        return "Sphere";
    }

    @Override
    public String[] getCles() {
        return new String[] {"centre", "rayon"};
    }

    @Override
    public Objet3D lire(Section valeurs) {
        return new Sphere(valeurs.point("centre"), valeurs.longueur("rayon"));
    }
}
