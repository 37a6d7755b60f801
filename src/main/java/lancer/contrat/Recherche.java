package lancer.contrat;

import java.util.concurrent.CancellationException;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;

/** La recherche d'un contact : même image que les deux boucles de {@link lancer.Scene}, au bit près, et plus vite. */
public interface Recherche {

    /**
     * Note dans ce rayon, de direction unitaire, son premier contact (+∞ s'il n'y en a pas), à la place du précédent. À
     * distance égale, l'objet qui vient d'abord dans la scène l'emporte. {@code saufLui} n'est jamais rendu.
     */
    void plusProche(Rayon incident, Objet3D saufLui);

    /**
     * Dit si le rayon d'ombre rencontre avant cette distance un objet autre que {@code objet}, l'objet éclairé. Le
     * rayon part de P, en général la lampe, dans la direction V, de longueur 1.
     */
    boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet);

    /** La même recherche pour un fil, qui compte dans {@code compteurs} ; {@code null} si elle a un écart. */
    Recherche pourUnFil(Compteurs compteurs);

    /** Vérifie que les objets sont ceux qu'elle a copiés. */
    default void verifier() {
    }

    /** Phrase sur la première réponse qui diffère de celle des boucles ; {@code null} s'il n'y en a pas. */
    default String getEcart() {
        return null;
    }

    /** Temps de construction des structures, pendant la préparation et pendant le dessin, en nanosecondes. */
    default long getConstructionNs() {
        return 0;
    }

    /** À appeler une fois par milliseconde. @throws CancellationException si ce fil est interrompu ; il le reste */
    static void obeir() {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("travail interrompu");
        }
    }

    /** @throws ArithmeticException si cette distance, rendue par cet objet, est NaN */
    static double verifier(double d, Objet3D objet) {
        if (Double.isNaN(d)) {
            throw new ArithmeticException(objet.getClass().getName() + ".getIntersectionDistance a rendu NaN");
        }
        return d;
    }
}
