package lancer.contrat;

import lancer.Couleur;
import lancer.Lampe;
import lancer.PointContact;
import lancer.Vecteur;

/**
 * Récit d'un pixel, que font les classes du cours en le calculant, à qui le demande ; d'ordinaire personne,
 * et {@code e} est {@code null}. Un rayon se dit dans l'ordre : son contact, les lampes, le reflet (donc le rayon
 * suivant, en entier), et enfin ce qu'il voit.
 *
 * <p>Qui écoute reçoit des copies : un objet qu'on lui donnerait n'aurait plus le droit de ne vivre que dans les
 * registres, même quand personne n'écoute.
 */
public interface Ecoute {

    /** Un rayon de direction V, et ce qu'il rencontre d'abord : {@code null} si c'est le ciel. */
    void auRayon(Vecteur V, PointContact contact);

    /** La normale à ce contact, et le miroir du rayon ; une forme qui se colore à sa façon n'en dit rien. */
    void auContact(Vecteur N, Vecteur R);

    /** Une lampe est-elle devant la surface ? {@code devant} est N·(lampe − contact), qui n'est pas normalisé. */
    void aLaLampe(Lampe lampe, double devant);

    /** Lumière que donnerait cette lampe, qui est devant, si rien ne la cachait. */
    void aLEclairement(double cosinus, double eclat, Couleur diffus, Couleur reflet);

    /** Question d'un rayon d'ombre : une lampe est-elle cachée ? {@code L} va du contact à la lampe. */
    void aLOmbre(Vecteur L, double distance);

    /** Un terme de la somme du contact : une lampe qui n'est pas cachée, puis le reflet des objets. */
    void aLaSomme(Couleur terme);

    /** Produit des Ks, qui dit si le reflet vaut d'être suivi. */
    void auPoids(Couleur produitKs);

    /** Couleur que voit enfin ce rayon : la somme de son contact, ou le ciel, puis à travers l'air. */
    void aLaVue(Couleur somme, Couleur vue);

    static void rayon(Ecoute e, Vecteur V, PointContact contact) {
        if (e != null) {
            e.auRayon(new Vecteur(V.x, V.y, V.z), contact);
        }
    }

    static void ombre(Ecoute e, Vecteur L, double distance) {
        if (e != null) {
            e.aLOmbre(new Vecteur(L.x, L.y, L.z), distance);
        }
    }

    static void vue(Ecoute e, Couleur somme, Couleur vue) {
        if (e != null) {
            e.aLaVue(new Couleur(somme.r, somme.v, somme.b), new Couleur(vue.r, vue.v, vue.b));
        }
    }
}
