package lancer.rapide;

import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/** La recherche d'une scène de beaucoup d'objets, pour un fil. Chaque rayon a sa {@link Question}. */
final class Foule implements Recherche {

    private final Preparation preparation;
    final Structures structures;
    final Compteurs compteurs;

    /** La question à laquelle la boucle répond. */
    Question courante;

    /** Rang de la dernière lampe demandée ; en général, la suivante vient juste après. */
    private int lampe;

    /** Rang du dernier contact ; en général, un rayon d'ombre ou réfléchi vient ensuite de lui. */
    int contact = -1;

    Foule(Preparation preparation, Compteurs compteurs) {
        this.preparation = preparation;
        this.compteurs = compteurs;
        structures = preparation.getStructures();
    }

    @Override
    public Question candidats(Rayon rayon, Objet3D depart, double portee) {
        Recherche.obeir();
        compteurs.compter(rayon, depart, portee);
        courante = new Question(this, rayon, depart, portee);
        return courante;
    }

    /** D'où part ce rayon d'ombre : le point de vue de la lampe ; {@code null} s'il n'y en a pas. */
    PointDeVue trouverLaLampe(Point p) {
        Point[] lampes = structures.lampes;
        // un rayon d'ombre qui part du contact ne part pas d'une lampe
        for (int k = p instanceof PointContact ? lampes.length : 0; k < lampes.length; k++) {
            if (lampes[lampe] == p) {
                return structures.vues[lampe];
            }
            lampe = lampe + 1 < lampes.length ? lampe + 1 : 0;
        }
        return null;
    }

    @Override
    public void limiter(double distance) {
        courante.limiter(distance);
    }

    @Override
    public Objet3D aEgalite(Objet3D plusProche) {
        return courante.aEgalite(plusProche);
    }

    @Override
    public Recherche pourUnFil(Compteurs autres) {
        return new Foule(preparation, autres);
    }
}
