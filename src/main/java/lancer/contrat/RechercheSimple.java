package lancer.contrat;

import java.util.List;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;

/** Les deux boucles du cours : tous les objets, l'un après l'autre. */
public class RechercheSimple implements Recherche {

    private final List<Objet3D> objets;
    private final Compteurs compteurs;

    public RechercheSimple(List<Objet3D> objets, Compteurs compteurs) {
        this.objets = objets;
        this.compteurs = compteurs;
    }

    @Override
    public void plusProche(Rayon incident, Objet3D saufLui) {
        Objet3D plusProche = null;
        double distance = Constantes.INFINI;
        for (Objet3D objet : objets) {
            if (objet != saufLui) {
                compteurs.testsSpheres++;
                double d = distance(objet, incident);
                if (d < distance) {
                    plusProche = objet;
                    distance = d;
                }
            }
        }
        incident.setContact(plusProche, distance);
    }

    @Override
    public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
        Rayon ombre = Rayon.dOmbre(P, V);
        for (Objet3D autre : objets) {
            if (autre != objet) {
                compteurs.testsSpheres++;
                if (distance(autre, ombre) < distance) {
                    return true;
                }
            }
        }
        return false;
    }

    /** @throws ArithmeticException si l'objet répond ce qui n'est pas un nombre */
    public static double distance(Objet3D objet, Rayon rayon) {
        double d = objet.getIntersectionDistance(rayon);
        if (Double.isNaN(d)) {
            throw new ArithmeticException(objet.getClass().getName() + ".getIntersectionDistance a rendu NaN");
        }
        return d;
    }

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return new RechercheSimple(objets, compteurs);
    }
}
