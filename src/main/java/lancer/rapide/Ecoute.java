package lancer.rapide;

import java.util.ArrayList;
import java.util.List;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/** Une recherche dont on retient les questions. */
final class Ecoute implements Recherche {

    private final Recherche ecoutee;
    private final Compteurs compteurs;

    /** Les questions, dans l'ordre où elles viennent. */
    final List<Question> questions = new ArrayList<>();

    /** @param recherche dont une vue de plus est écoutée */
    Ecoute(Recherche recherche) {
        compteurs = new Compteurs();
        ecoutee = recherche.pourUnFil(compteurs);
    }

    @Override
    public void plusProche(Rayon incident, Objet3D saufLui) {
        long avant = examines();
        ecoutee.plusProche(incident, saufLui);
        questions.add(new Question(incident, saufLui, examines() - avant));
    }

    @Override
    public boolean estCachee(Lampe lampe, Point contact, Vecteur L, double distance, Objet3D objet) {
        long avant = examines();
        boolean cachee = ecoutee.estCachee(lampe, contact, L, distance, objet);
        questions.add(new Question(lampe, contact, L, distance, objet, cachee, examines() - avant));
        return cachee;
    }

    private long examines() {
        return compteurs.testsSpheres + compteurs.noeudsVisites;
    }

    @Override
    public Recherche pourUnFil(Compteurs autres) {
        return ecoutee.pourUnFil(autres);
    }
}
