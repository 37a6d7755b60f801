package lancer;

/**
 * Une somme de couleurs en cours, noire au début : une seule sert à toutes les lampes d'un contact, et à son reflet.
 */
final class Lumiere {

    private double r;
    private double v;
    private double b;

    void ajouter(Couleur c) {
        r += c.r;
        v += c.v;
        b += c.b;
    }

    Couleur getCouleur() {
        return new Couleur(r, v, b);
    }
}
