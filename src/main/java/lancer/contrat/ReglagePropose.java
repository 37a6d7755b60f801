package lancer.contrat;

/** Un réglage qu'une variante propose à {@code --auto}, avec son effet sur une scène ordinaire. Immuable. */
public final class ReglagePropose {

    /** La section du réglage, son erreur ordinaire, en niveaux, et son prix : 1 est celui d'un rayon par pixel. */
    public final Section section;
    public final double erreur;
    public final double prix;

    public ReglagePropose(Section section, double erreur, double prix) {
        this.section = section;
        this.erreur = erreur;
        this.prix = prix;
    }
}
