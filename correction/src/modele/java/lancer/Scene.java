package lancer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Les objets, qui sont tous des sphères, et les lampes (cours, « Scène de sphères »). */
public class Scene {

    private final List<Objet3D> objets;
    private final List<Lampe> lampes;
    //<brume
    //+ private Brume brume = new Brume(Constantes.INFINI);
    //>

    /** Lit une scène dans un fichier. */
    public Scene(String nomFichier) {
        this(new LecteurScene(nomFichier));
    }

    private Scene(LecteurScene lu) {
        this(lu.getObjets(), lu.getLampes());
        //<brume
        //+ brume = lu.getBrume();
        //>
    }

    /** Une scène sans fichier. */
    public Scene(List<? extends Objet3D> objets, List<Lampe> lampes) {
        this.objets = new ArrayList<>(objets);
        this.lampes = new ArrayList<>(lampes);
    }

    /** Le premier objet que rencontre ce rayon, {@code null} s'il n'y en a pas. */
    public PointContact getClosestIntersection(Rayon incident) {
        return getClosestIntersection(incident, (Sphere) null);
    }

    /**
     * Le contact du rayon avec l'objet le plus proche, {@code null} s'il n'y en a pas. À la fin, le rayon doit avoir
     * noté ce contact.
     *
     * @param saufLui l'objet à ignorer : celui d'où part le rayon, ou {@code null}
     */
    public PointContact getClosestIntersection(Rayon incident, Sphere saufLui) {
        //{ compléter : parcourir tous les objets, sauf celui qu'il faut ignorer
        Objet3D plusProche = null;
        double distance = Constantes.INFINI;
        for (Objet3D objet : objets) {
            if (objet != saufLui) {
                double d = objet.getIntersectionDistance(incident);
                if (d < distance) {
                    plusProche = objet;
                    distance = d;
                }
            }
        }
        incident.setContact(plusProche, distance);
        return incident.calcContact();
        //= return null;
        //}
    }

    /** La même chose, pour qui l'appelle depuis {@link Objet3D}, où {@code this} n'est pas déclaré comme une sphère. */
    public PointContact getClosestIntersection(Rayon incident, Objet3D saufLui) {
        return getClosestIntersection(incident, (Sphere) saufLui);
    }

    //<brume
    //+ public Brume getBrume() {
    //+     return brume;
    //+ }
    //+
    //>
    public List<Objet3D> getObjets() {
        return Collections.unmodifiableList(objets);
    }

    public List<Lampe> getLampes() {
        return Collections.unmodifiableList(lampes);
    }
}
