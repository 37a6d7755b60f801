package lancer.contrat;

import lancer.Couleur;
import lancer.Lampe;
import lancer.PointContact;
import lancer.Vecteur;

/**
 * Ce que les classes du cours disent à l'inspecteur du calcul d'un point de l'écran, dans l'ordre : un rayon, son
 * contact, les lampes, le rayon réfléchi en entier, puis la couleur vue. Un dessin n'en a pas.
 */
public interface Ecoute {

    /** Un rayon de direction V, et son contact, {@code null} pour le ciel. */
    void rayon(Vecteur V, PointContact contact);

    /** La normale du contact, et la direction réfléchie. */
    void normale(Vecteur N, Vecteur R);

    /** Une lampe : les couleurs ajoutées désormais sont la sienne. @param devant N·(lampe − contact) */
    void lampe(Lampe lampe, double devant);

    /** Ce qu'ajoute cette lampe, si aucun objet ne la cache. */
    void apport(double cosinus, double eclat, Couleur diffus, Couleur reflet);

    /** Un rayon d'ombre vers cette lampe. */
    void ombre(Vecteur L, double distance);

    /** Le produit des Ks, qui décide du rayon réfléchi. */
    void poids(Couleur produitKs);

    void ajouter(Couleur c);

    /** La couleur du contact ou du ciel, puis la même à travers l'air. */
    void vue(Couleur somme, Couleur vue);
}
