package lancer.contrat;

import java.util.List;
import lancer.Objet3D;
import lancer.Rayon;

/** La recherche du cours : elle propose tous les objets, dans l'ordre de la scène. */
public final class TousLesObjets implements Recherche {

    private final Objet3D[] objets;
    private final Compteurs compteurs;

    public TousLesObjets(List<Objet3D> objets) {
        this(objets.toArray(new Objet3D[0]), new Compteurs());
    }

    private TousLesObjets(Objet3D[] objets, Compteurs compteurs) {
        this.objets = objets;
        this.compteurs = compteurs;
    }

    @Override
    public Iterable<Objet3D> candidats(Rayon rayon, Objet3D depart, double portee) {
        Recherche.obeir();
        compteurs.compter(rayon, depart, portee);
        return new Parcours(objets, rayon, depart, compteurs);
    }

    @Override
    public void limiter(double distance) {
        // la boucle les demande tous
    }

    @Override
    public Objet3D aEgalite(Objet3D plusProche) {
        return plusProche;
    }

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return new TousLesObjets(objets, compteurs);
    }
}
