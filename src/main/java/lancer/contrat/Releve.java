package lancer.contrat;

/** Ce qu'un pavé a montré à l'échantillonnage qui l'a dessiné. Immuable. */
public final class Releve {

    /** Celui d'un pavé dont aucun pixel n'est raffiné, et qui n'apprend rien du reste de l'image. */
    public static final Releve RIEN = new Releve(0);

    /** Nombre de pixels raffinés. */
    public final int raffines;
    /**
     * Ce que ce pavé laisse craindre du reste de l'image, ou l'inverse s'il est négatif. Où la somme de ceux de toute
     * l'image est positive, des détails ont dû échapper, et l'image se regarde une seconde fois.
     */
    public final double soupcon;
    /** Vrai si un second regard dessinerait ce pavé autrement. */
    public final boolean aRevoir;

    public Releve(int raffines, double soupcon, boolean aRevoir) {
        this.raffines = raffines;
        this.soupcon = soupcon;
        this.aRevoir = aRevoir;
    }

    /** Celui d'un échantillonnage qui ne regarde qu'une fois. */
    public Releve(int raffines) {
        this(raffines, 0, false);
    }
}
