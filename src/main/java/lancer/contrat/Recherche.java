package lancer.contrat;

import java.util.concurrent.CancellationException;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;

/**
 * La seule porte de la vitesse : ce que les rayons demandent à une scène. Une recherche, si la scène en a une, répond
 * à la place des deux boucles de {@link lancer.Scene}, et donne la même image au bit près.
 */
public interface Recherche {

    /**
     * Note dans ce rayon, de direction unitaire, son premier contact (+∞ si rien), sans égard à ce qui y était : à la
     * même distance, celui de l'objet qui vient d'abord dans la scène ; jamais celui de {@code saufLui}.
     */
    void plusProche(Rayon incident, Objet3D saufLui);

    /**
     * Un rayon d'ombre de cette lampe, parti de P (d'ordinaire, d'elle) vers V, de longueur 1, rencontre-t-il un autre
     * objet que celui-ci, qui est éclairé, avant cette distance ?
     */
    boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet);

    /** Recherche d'un fil de plus, qui comptera dans {@code compteurs}. */
    Recherche pourUnFil(Compteurs compteurs);

    /** Temps qu'une recherche a mis à construire, préparation et demandes des rayons comprises, en nanosecondes. */
    default long getConstructionNs() {
        return 0;
    }

    /** Obéit, une fois par milliseconde. @throws CancellationException si ce fil est interrompu, et il le reste */
    static void obeir() {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("travail interrompu");
        }
    }

    /** @throws ArithmeticException si cette distance, qu'a rendue cet objet, n'est pas un nombre */
    static double verifier(double d, Objet3D objet) {
        if (Double.isNaN(d)) {
            throw new ArithmeticException(objet.getClass().getName() + ".getIntersectionDistance a rendu NaN");
        }
        return d;
    }
}
