package lancer.contrat;

/** Un barreau de l'échelle d'une variante : un réglage, et ce qu'il donne sur une scène ordinaire. Immuable. */
public final class Barreau {

    /** Les valeurs du réglage, son erreur ordinaire, en niveaux, et son prix, en fois celui d'un rayon par pixel. */
    public final Section section;
    public final double erreur;
    public final double prix;

    public Barreau(Section section, double erreur, double prix) {
        this.section = section;
        this.erreur = erreur;
        this.prix = prix;
    }
}
