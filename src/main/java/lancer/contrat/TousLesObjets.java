package lancer.contrat;

import java.util.Iterator;
import java.util.List;
import lancer.Objet3D;
import lancer.Rayon;

/** La recherche du cours : elle propose tous les objets, dans l'ordre de la scène. */
public final class TousLesObjets implements Recherche {

    private final Objet3D[] objets;
    private final Compteurs compteurs;

    /** @param objets dans l'ordre de la scène */
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
        return new Passage(rayon, depart);
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
    public Recherche pourUnFil(Compteurs compteursDuFil) {
        return new TousLesObjets(objets, compteursDuFil);
    }

    /** Le passage d'un rayon. Chaque question a le sien : une boucle peut donc en poser une autre. */
    private final class Passage implements Iterable<Objet3D>, Iterator<Objet3D> {

        private final Rayon rayon;
        private final Objet3D depart;
        private int rang;

        Passage(Rayon rayon, Objet3D depart) {
            this.rayon = rayon;
            this.depart = depart;
        }

        @Override
        public Iterator<Objet3D> iterator() {
            return this;
        }

        @Override
        public boolean hasNext() {
            if (Double.isNaN(rayon.getDistance()) && rang > 0) {
                Recherche.getDistance(objets[rang - 1], rayon);
            }
            return rang < objets.length;
        }

        @Override
        public Objet3D next() {
            Objet3D objet = objets[rang++];
            if (objet != depart) {
                compteurs.testsSpheres++;
                rayon.setContact(null, Double.NaN);
            }
            return objet;
        }
    }
}
