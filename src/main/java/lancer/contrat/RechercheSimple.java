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

    /** Objets examinés, moins un, entre deux regards à l'interruption du fil : un dixième de milliseconde. */
    private static final long PAS = (1 << 14) - 1;

    private final List<Objet3D> objets;
    private final Compteurs compteurs;
    private final String ecart;

    public RechercheSimple(List<Objet3D> objets, Compteurs compteurs) {
        this(objets, compteurs, null);
    }

    /** @param ecart voir {@link #getEcart()} */
    public RechercheSimple(List<Objet3D> objets, Compteurs compteurs, String ecart) {
        this.objets = objets;
        this.compteurs = compteurs;
        this.ecart = ecart;
    }

    @Override
    public void plusProche(Rayon incident, Objet3D saufLui) {
        Objet3D plusProche = null;
        double distance = Constantes.INFINI;
        Recherche.obeir();
        for (Objet3D objet : objets) {
            if (objet != saufLui) {
                compter();
                double d = verifier(objet.getIntersectionDistance(incident), objet);
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
                if (verifier(autre.getIntersectionDistance(ombre), autre) < distance) {
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

    /** @throws ArithmeticException si cette distance, qu'a rendue cet objet, n'est pas un nombre */
    public static double verifier(double d, Objet3D objet) {
        if (Double.isNaN(d)) {
            throw new ArithmeticException(objet.getClass().getName() + ".getIntersectionDistance a rendu NaN");
        }
        return d;
    }

    @Override
    public String getEcart() {
        return ecart;
    }

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return new RechercheSimple(objets, compteurs, ecart);
    }
}
