package lancer.rapide;

import java.util.function.Consumer;
import java.util.function.Supplier;
import lancer.Objet3D;
import lancer.Rayon;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/** La recherche d'une scène de beaucoup d'objets, pour un fil. */
final class Foule implements Recherche {

    private final Supplier<Structures> preparation;
    private final Structures structures;
    private final Compteurs compteurs;
    private final Consumer<Question> suivi;

    /** La question que pose la boucle : la dernière posée, ou la dernière qui a proposé un objet. */
    private Question enCours;

    /** Rang du dernier contact ; en général, un rayon d'ombre ou réfléchi vient ensuite de lui. */
    private int contact = -1;

    Foule(Supplier<Structures> preparation, Compteurs compteurs) {
        this.preparation = preparation;
        this.compteurs = compteurs;
        structures = preparation.get();
        suivi = question -> enCours = question;
        enCours = new Question(suivi, structures, compteurs);
    }

    @Override
    public Iterable<Objet3D> candidats(Rayon rayon, Objet3D depart, double portee) {
        Recherche.obeir();
        // une boucle interrompue pourrait continuer : sa question n'est pas reprise
        enCours = enCours.estFinie() ? enCours : new Question(suivi, structures, compteurs);
        boolean connu = contact >= 0 && structures.enveloppes.objets[contact] == depart;
        return enCours.poser(rayon, depart, connu ? contact : -1, portee);
    }

    @Override
    public void limiter(double distance) {
        enCours.limiter(distance);
    }

    @Override
    public Objet3D aEgalite(Objet3D plusProche) {
        int rang = enCours.aEgalite(plusProche);
        if (rang < 0) {
            return plusProche;
        }
        contact = rang;
        return structures.enveloppes.objets[rang];
    }

    @Override
    public Recherche pourUnFil(Compteurs compteursDuFil) {
        return new Foule(preparation, compteursDuFil);
    }
}
