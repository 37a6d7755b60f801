package lancer;

import lancer.contrat.Ecoute;
import lancer.contrat.Modele;

/**
 * La somme des lumières qu'un contact renvoie vers le rayon. Si la scène a une {@link Ecoute}, une copie de chaque
 * terme y est notée : le terme lui-même, que rien ne garde, n'est alors pas alloué.
 */
final class Lumiere {

    /** Détail du calcul pour l'inspecteur ; {@code null} pendant le dessin d'une image. */
    private final Ecoute ecoute;
    private final double seuil;
    private double r;
    private double v;
    private double b;

    /**
     * @param N normale au contact
     * @param R direction réfléchie du rayon incident
     */
    Lumiere(Modele modele, Vecteur N, Vecteur R) {
        ecoute = modele.getEcoute();
        seuil = modele.getSeuil();
        if (ecoute != null) {
            ecoute.normale(new Vecteur(N.x, N.y, N.z), new Vecteur(R.x, R.y, R.z));
        }
    }

    /** Dit si cette lampe est devant la surface. @param devant N·(lampe − contact), dont seul le signe compte */
    boolean estDevant(Lampe lampe, double devant) {
        if (ecoute != null) {
            ecoute.lampe(lampe, devant);
        }
        return devant > 0;
    }

    /** Apport d'une lampe de couleur KL, si aucun objet ne la cache : Kd ⊗ KL · cosinus + Ks ⊗ KL · éclat. */
    Couleur apport(Couleur KL, Couleur Kd, double cosinus, Couleur Ks, double eclat) {
        Couleur diffus = Kd.mul(KL).mul(cosinus);
        Couleur reflet = Ks.mul(KL).mul(eclat);
        if (ecoute != null) {
            ecoute.apport(cosinus, eclat, Kd.mul(KL).mul(cosinus), Ks.mul(KL).mul(eclat));
        }
        return diffus.add(reflet);
    }

    /** Dit si le rayon réfléchi doit être lancé : la plus grande composante du produit des Ks atteint le seuil. */
    boolean vautUnReflet(Couleur produitKs) {
        if (ecoute != null) {
            ecoute.poids(new Couleur(produitKs.r, produitKs.v, produitKs.b));
        }
        return produitKs.max() >= seuil;
    }

    /** Ajoute l'apport d'une lampe visible, ou la couleur du rayon réfléchi multipliée par Ks. */
    void ajouter(Couleur c) {
        if (ecoute != null) {
            ecoute.ajouter(new Couleur(c.r, c.v, c.b));
        }
        r += c.r;
        v += c.v;
        b += c.b;
    }

    Couleur getCouleur() {
        return new Couleur(r, v, b);
    }
}
