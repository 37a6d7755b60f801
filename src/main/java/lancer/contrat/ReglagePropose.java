package lancer.contrat;

/** Un réglage qu'une variante propose à {@code --auto}, et ce qu'il donne sur une scène ordinaire. Immuable. */
public final class ReglagePropose {

    /** Les valeurs du réglage, son erreur ordinaire, en niveaux, et son prix, en fois celui d'un rayon par pixel. */
    public final Section section;
    public final double erreur;
    public final double prix;

    public ReglagePropose(Section section, double erreur, double prix) {
        this.section = section;
        this.erreur = erreur;
        this.prix = prix;
    }
}
