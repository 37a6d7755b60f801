package lancer.contrat;

import lancer.Couleur;
import lancer.Lampe;
import lancer.PointContact;
import lancer.Vecteur;

/**
 * Ce que les classes du cours disent d'un pixel pendant qu'elles le calculent, à qui le demande ; d'ordinaire personne,
 * et {@code e} est {@code null}. Un contact se dit dans l'ordre : lui-même, ses lampes, son reflet (donc le contact
 * suivant, en entier), l'air, et enfin ce que voit le rayon.
 *
 * <p>Celui qui écoute reçoit des copies : un objet qu'on lui donnerait n'aurait plus le droit de ne vivre que dans les
 * registres, même quand personne n'écoute.
 */
public interface Ecoute {

    /** Ce que voit enfin le rayon parti de l'écran en (xe, ye). */
    void auRegard(double xe, double ye, Couleur couleur);

    /** La couleur d'un regard, celle-là même, compte tant dans le pixel en cours. */
    void auCompte(Couleur couleur, double poids);

    /** Un contact : sa normale, et le miroir du rayon. */
    void auContact(PointContact contact, Vecteur N, Vecteur R);

    /** Une lampe est-elle devant la surface ? {@code devant} est N·(lampe − contact), qui n'est pas normalisé. */
    void aLaLampe(Lampe lampe, double devant);

    /** Ce que donnerait cette lampe, qui est devant. */
    void aLEclairement(double cosinus, double eclat, Couleur diffus, Couleur reflet);

    /** Est-elle cachée ? {@code L} va du contact à la lampe. */
    void aLOmbre(Vecteur L, double distance);

    /** Un terme de la somme du contact : une lampe qui n'est pas cachée, puis le reflet des objets. */
    void aLaSomme(Couleur terme);

    /** Le produit des Ks, qui dit si le reflet vaut d'être suivi. */
    void auPoids(Couleur produitKs);

    /** Ce que l'air fait de la somme : k, et les deux termes de ce qu'il laisse voir. */
    void aLAir(double k, Couleur air, Couleur reste);

    /** Ce que voit un rayon : la somme de son contact, ou le ciel si {@code contact} est nul, puis à travers l'air. */
    void aLaVue(PointContact contact, Couleur somme, Couleur vue);

    static void regard(Ecoute e, double xe, double ye, Couleur couleur) {
        if (e != null) {
            e.auRegard(xe, ye, couleur);
        }
    }

    static void compte(Ecoute e, Couleur couleur, double poids) {
        if (e != null) {
            e.auCompte(couleur, poids);
        }
    }

    static void contact(Ecoute e, PointContact contact, Vecteur N, Vecteur R) {
        if (e != null) {
            e.auContact(contact, new Vecteur(N.x, N.y, N.z), new Vecteur(R.x, R.y, R.z));
        }
    }

    static void lampe(Ecoute e, Lampe lampe, double devant) {
        if (e != null) {
            e.aLaLampe(lampe, devant);
        }
    }

    static void eclairement(Ecoute e, double cosinus, double eclat, Couleur diffus, Couleur reflet) {
        if (e != null) {
            e.aLEclairement(cosinus, eclat, new Couleur(diffus.r, diffus.v, diffus.b),
                    new Couleur(reflet.r, reflet.v, reflet.b));
        }
    }

    static void ombre(Ecoute e, Vecteur L, double distance) {
        if (e != null) {
            e.aLOmbre(new Vecteur(L.x, L.y, L.z), distance);
        }
    }

    static void somme(Ecoute e, Couleur terme) {
        if (e != null) {
            e.aLaSomme(new Couleur(terme.r, terme.v, terme.b));
        }
    }

    static void poids(Ecoute e, Couleur produitKs) {
        if (e != null) {
            e.auPoids(new Couleur(produitKs.r, produitKs.v, produitKs.b));
        }
    }

    static void air(Ecoute e, double k, Couleur air, Couleur reste) {
        if (e != null) {
            e.aLAir(k, new Couleur(air.r, air.v, air.b), new Couleur(reste.r, reste.v, reste.b));
        }
    }

    static void vue(Ecoute e, PointContact contact, Couleur somme, Couleur vue) {
        if (e != null) {
            e.aLaVue(contact, new Couleur(somme.r, somme.v, somme.b), new Couleur(vue.r, vue.v, vue.b));
        }
    }
}
