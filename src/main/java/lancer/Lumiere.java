package lancer;

import lancer.contrat.Ecoute;

/**
 * Une somme de couleurs en cours, noire au début : une seule sert à toutes les lampes d'un contact, et à son reflet.
 */
final class Lumiere {

    private final Ecoute ecoute;
    private double r;
    private double v;
    private double b;

    Lumiere(Ecoute ecoute) {
        this.ecoute = ecoute;
    }

    void ajouter(Couleur c) {
        Ecoute.somme(ecoute, c);
        r += c.r;
        v += c.v;
        b += c.b;
    }

    Couleur getCouleur() {
        return new Couleur(r, v, b);
    }
}
