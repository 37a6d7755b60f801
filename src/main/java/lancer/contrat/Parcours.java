package lancer.contrat;

import java.util.Iterator;
import lancer.Objet3D;
import lancer.Rayon;

/** Le passage d'un rayon sur tous les objets. Avant chacun, il vérifie la réponse du précédent. */
final class Parcours implements Iterable<Objet3D>, Iterator<Objet3D> {

    private final Objet3D[] objets;
    private final Rayon rayon;
    private final Objet3D depart;
    private final Compteurs compteurs;
    private int suivant;

    /** @param depart l'objet que la boucle ne demande pas, ou {@code null} */
    Parcours(Objet3D[] objets, Rayon rayon, Objet3D depart, Compteurs compteurs) {
        this.objets = objets;
        this.rayon = rayon;
        this.depart = depart;
        this.compteurs = compteurs;
    }

    @Override
    public Iterator<Objet3D> iterator() {
        return this;
    }

    @Override
    public boolean hasNext() {
        if (Double.isNaN(rayon.getDistance()) && suivant > 0) {
            Recherche.getDistance(objets[suivant - 1], rayon);
        }
        return suivant < objets.length;
    }

    @Override
    public Objet3D next() {
        Objet3D objet = objets[suivant++];
        if (objet != depart) {
            compteurs.testsSpheres++;
            rayon.oublier();
        }
        return objet;
    }
}
