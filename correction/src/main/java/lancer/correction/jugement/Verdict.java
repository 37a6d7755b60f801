package lancer.correction.jugement;

/** Résultat d'une vérification. */
public final class Verdict {

    /** États, du meilleur au pire. */
    public enum Etat {
        REUSSI("réussi"),
        /** La classe, seule parmi celles du corrigé, est juste ; une autre l'empêche de le montrer. */
        CACHE("juste, caché par une autre classe"),
        /** Une extension, dont l'image ne montre qu'une part. */
        PARTIEL("en partie"),
        NON_EVALUABLE("non évaluable"),
        NON_COMMENCE("non commencé"),
        NE_SE_COMPILE_PAS("ne se compile pas"),
        RATE("raté");

        public final String texte;

        Etat(String texte) {
            this.texte = texte;
        }
    }

    public final Etat etat;
    public final String message;
    /** Part que la vérification rapporte de ses points, de 0 à 1. */
    public final double part;

    public Verdict(Etat etat, String message) {
        this(etat, message, etat == Etat.REUSSI || etat == Etat.CACHE ? 1 : 0);
    }

    Verdict(Etat etat, String message, double part) {
        this.etat = etat;
        this.message = message;
        this.part = part;
    }

    /** Raté, ou qui ne se compile pas, si c'est ce que dit ce message. */
    static Verdict rate(String message) {
        return new Verdict(message.startsWith(Juge.NE_SE_COMPILE_PAS) ? Etat.NE_SE_COMPILE_PAS : Etat.RATE, message);
    }

    /** Vrai si c'est une faute : ratée, ou qui ne se compile pas. */
    public boolean rate() {
        return etat == Etat.RATE || etat == Etat.NE_SE_COMPILE_PAS;
    }

    /** Vrai si la vérification rapporte ses points. */
    public boolean compte() {
        return part == 1;
    }
}
