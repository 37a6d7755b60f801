package lancer.rapide;

import java.util.function.Supplier;
import lancer.Objet3D;
import lancer.Rayon;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/** La recherche d'une scène de beaucoup d'objets, pour un fil. Chaque rayon a sa {@link Question}. */
final class Foule implements Recherche {

    private final Supplier<Structures> preparation;
    private final Memoire memoire;

    Foule(Supplier<Structures> preparation, Compteurs compteurs) {
        this.preparation = preparation;
        memoire = new Memoire(preparation.get(), compteurs);
    }

    @Override
    public Iterable<Objet3D> candidats(Rayon rayon, Objet3D depart, double portee) {
        Recherche.obeir();
        memoire.compteurs.compter(rayon, depart, portee);
        return new Question(memoire, rayon, depart, portee);
    }

    @Override
    public void limiter(double distance) {
        memoire.limite = distance;
    }

    @Override
    public Objet3D aEgalite(Objet3D plusProche) {
        Objet3D[] objets = memoire.structures.enveloppes.objets;
        if (memoire.proche < 0 || objets[memoire.proche] != plusProche) {
            return plusProche;
        }
        memoire.contact = memoire.premier;
        return objets[memoire.premier];
    }

    @Override
    public Recherche pourUnFil(Compteurs autres) {
        return new Foule(preparation, autres);
    }
}
