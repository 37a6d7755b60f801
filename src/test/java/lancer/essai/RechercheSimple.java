package lancer.essai;

import java.util.List;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/** Les deux boucles du cours, récrites : tous les objets, l'un après l'autre. Ce à quoi une recherche se compare. */
public class RechercheSimple implements Recherche {

    /** Objets examinés, moins un, entre deux regards à l'interruption du fil : un dixième de milliseconde. */
    private static final long PAS = (1 << 14) - 1;

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
        Recherche.obeir();
        for (Objet3D objet : objets) {
            if (objet != saufLui) {
                compter();
                double d = Recherche.verifier(objet.getIntersectionDistance(incident), objet);
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
                compter();
                if (Recherche.verifier(autre.getIntersectionDistance(ombre), autre) < distance) {
                    return true;
                }
            }
        }
        return false;
    }

    private void compter() {
        if ((++compteurs.testsSpheres & PAS) == 0) {
            Recherche.obeir();
        }
    }

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return new RechercheSimple(objets, compteurs);
    }
}
