package lancer.contrat;

/** Un réglage qu'une variante propose à {@code --auto} et à la fenêtre. Immuable. */
public final class ReglagePropose {

    /** La section du réglage, et le seuil des reflets dont l'erreur est petite devant la sienne. */
    public final Section section;
    public final double seuil;

    public ReglagePropose(Section section, double seuil) {
        this.section = section;
        this.seuil = seuil;
    }
}
