package lancer.contrat;

import java.util.concurrent.CancellationException;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Vecteur;

/**
 * Un curseur sur les objets qu'un rayon peut rencontrer. Les deux boucles de {@link lancer.Scene} le suivent, et
 * demandent sa distance à chaque objet. Une recherche propose ; elle ne répond pas. Elle appartient à un seul fil, et
 * traite une question à la fois.
 */
public interface Recherche {

    /**
     * Commence la question du premier contact.
     *
     * @param P départ du rayon
     * @param V sa direction, de longueur 1 en général
     * @param depart l'objet d'où il part, {@code null} pour un rayon de l'écran
     */
    void commencer(Point P, Vecteur V, Objet3D depart);

    /**
     * Commence la question d'une ombre. Celui qui la pose s'arrête au premier objet qui cache la lampe.
     *
     * @param P départ du rayon d'ombre : la lampe, ou le contact si elle est lointaine
     * @param distance longueur, depuis P, du segment que l'objet doit couper
     * @param eclaire l'objet du contact
     */
    default void commencerOmbre(Lampe lampe, Point P, Vecteur V, double distance, Objet3D eclaire) {
        commencer(P, V, eclaire);
    }

    /**
     * L'objet suivant, chacun une fois au plus, dans un ordre quelconque.
     *
     * @param auPlus un objet plus lointain est inutile ; un objet à cette distance ne l'est pas
     * @return son rang dans la scène, −1 à la fin
     */
    int suivant(double auPlus);

    /** La même recherche pour un fil, qui compte les nœuds visités dans {@code compteurs}. */
    Recherche pourUnFil(Compteurs compteurs);

    /** À appeler une fois par milliseconde. @throws CancellationException si ce fil est interrompu ; il le reste */
    static void obeir() {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("travail interrompu");
        }
    }
}
