package lancer.rapide;

import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Recherche;

/** Une question qu'un rayon a posée à une {@link Recherche}, et ce qu'elle a répondu. Immuable. */
final class Question {

    /** La lampe dont on demande si elle est cachée ; {@code null} si l'on demande le premier objet. */
    final Lampe lampe;
    /** Le rayon : celui de la question, ou le rayon d'ombre. */
    final Rayon rayon;
    /** L'objet à ignorer, ou {@code null}. */
    final Objet3D saufLui;
    /** La distance du contact trouvé, ou de la lampe. */
    final double distance;
    /** L'objet trouvé, {@code null} si aucun. */
    final Objet3D objet;
    final boolean cachee;
    /** Sphères et cases examinées pour y répondre. */
    final long cout;

    private final Point contact;
    private final Vecteur L;

    /** « Quel objet ce rayon rencontre-t-il d'abord ? » : la réponse est dans le rayon. */
    Question(Rayon rayon, Objet3D saufLui, long cout) {
        this.lampe = null;
        this.rayon = rayon;
        this.saufLui = saufLui;
        this.distance = rayon.getDistance();
        this.objet = rayon.getObjet();
        this.cachee = false;
        this.cout = cout;
        this.contact = null;
        this.L = null;
    }

    /** « Cette lampe est-elle cachée ? » */
    Question(Lampe lampe, Point contact, Vecteur L, double distance, Objet3D saufLui, boolean cachee, long cout) {
        this.lampe = lampe;
        this.rayon = Rayon.dOmbre(lampe, L);
        this.saufLui = saufLui;
        this.distance = distance;
        this.objet = null;
        this.cachee = cachee;
        this.cout = cout;
        this.contact = contact;
        this.L = L;
    }

    /** Vrai si cette recherche y répond de même, au bit près. */
    boolean memeReponse(Recherche autre) {
        if (lampe != null) {
            return autre.estCachee(lampe, contact, L, distance, saufLui) == cachee;
        }
        autre.plusProche(rayon, saufLui);
        return rayon.getObjet() == objet && Double.compare(rayon.getDistance(), distance) == 0;
    }
}
