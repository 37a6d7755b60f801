package lancer;

import lancer.contrat.Ecoute;

/**
 * La lumière qu'un contact renvoie vers le rayon : une somme, noire au début. Elle dit chaque terme à qui écoute la
 * scène, s'il y a quelqu'un ; en copie, car un vecteur ou une couleur ne doit sinon vivre que dans les registres.
 */
final class Lumiere {

    /** Récit du point de l'écran ; d'ordinaire {@code null}. */
    private final Ecoute ecoute;
    private final double seuil;
    private double r;
    private double v;
    private double b;

    /**
     * @param N normale au contact
     * @param R miroir du rayon incident
     * @param seuil au-dessous duquel le produit des Ks ne vaut pas un reflet
     */
    Lumiere(Ecoute ecoute, Vecteur N, Vecteur R, double seuil) {
        this.ecoute = ecoute;
        this.seuil = seuil;
        if (ecoute != null) {
            ecoute.enCours().N = new Vecteur(N.x, N.y, N.z);
            ecoute.enCours().R = new Vecteur(R.x, R.y, R.z);
        }
    }

    /**
     * Dit si cette lampe est devant la surface.
     *
     * @param devant N·(lampe − contact), qui n'est pas normalisé : le signe seul compte
     */
    boolean estDevant(Lampe lampe, double devant) {
        if (ecoute != null) {
            ecoute.enCours().lampes.add(ecoute.enCours().suivre(new Ecoute.Eclairage(lampe, null, devant)));
        }
        return devant > 0;
    }

    /** Apport d'une lampe de couleur KL si rien ne la cachait : Kd ⊗ KL · cosinus + Ks ⊗ KL · éclat. */
    Couleur apport(Couleur KL, Couleur Kd, double cosinus, Couleur Ks, double eclat) {
        Couleur diffus = Kd.mul(cosinus, KL);
        if (ecoute != null) {
            Ecoute.Eclairage dit = ecoute.enCours().enCours;
            dit.cosinus = cosinus;
            dit.eclat = eclat;
            dit.diffus = new Couleur(diffus.r, diffus.v, diffus.b);
            dit.reflet = Ks.mul(eclat, KL);
            dit.produit = dit.diffus.add(dit.reflet);
        }
        return diffus.add(eclat, Ks, KL);
    }

    /** Dit si un rayon réfléchi vaut d'être lancé : la plus grande composante du produit des Ks atteint le seuil. */
    boolean vautUnReflet(Couleur produitKs) {
        if (ecoute != null) {
            ecoute.enCours().poids = new Couleur(produitKs.r, produitKs.v, produitKs.b);
        }
        return produitKs.max() >= seuil;
    }

    /** Ajoute l'apport d'une lampe qui n'est pas cachée, ou, une fois pesé, ce que renvoie un reflet. */
    void ajouter(Couleur c) {
        if (ecoute != null) {
            ecoute.enCours().enCours.ajouts.add(new Couleur(c.r, c.v, c.b));
        }
        r += c.r;
        v += c.v;
        b += c.b;
    }

    Couleur getCouleur() {
        return new Couleur(r, v, b);
    }
}
