package lancer;

/** Une somme de lumières en cours, noire au début. */
final class Lumiere {

    private double r;
    private double v;
    private double b;

    void ajouter(Lumiere autre) {
        r += autre.r;
        v += autre.v;
        b += autre.b;
    }

    /** Ajoute K ⊗ lumiere · k : ce qu'une surface de couleur K renvoie de cette lumière. */
    void ajouter(Couleur K, Couleur lumiere, double k) {
        r += K.r * lumiere.r * k;
        v += K.v * lumiere.v * k;
        b += K.b * lumiere.b * k;
    }

    boolean estNoire() {
        return r == 0 && v == 0 && b == 0;
    }

    Couleur getCouleur() {
        return new Couleur(r, v, b);
    }
}
