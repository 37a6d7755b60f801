package lancer.correction.jugement;

/** Résultat d'une vérification. */
public final class Verdict {

    /** États, du meilleur au pire. */
    public enum Etat {
        REUSSI("réussi"),
        /** La classe, seule parmi celles du corrigé, est juste ; une autre l'empêche de le montrer. */
        CACHE("juste, caché par une autre classe"),
        /** Une extension rendue, dont l'enseignant donne les points. */
        A_NOTER("à noter"),
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

    public Verdict(Etat etat, String message) {
        this.etat = etat;
        this.message = message;
    }

    /** Raté, ou qui ne se compile pas, si c'est ce que dit ce message. */
    static Verdict rate(String message) {
        return new Verdict(message.startsWith(JugeRendu.NE_SE_COMPILE_PAS) ? Etat.NE_SE_COMPILE_PAS : Etat.RATE, message);
    }

    /** Vrai si c'est une faute : ratée, ou qui ne se compile pas. */
    public boolean rate() {
        return etat == Etat.RATE || etat == Etat.NE_SE_COMPILE_PAS;
    }

    /** Vrai si la vérification rapporte ses points. */
    public boolean compte() {
        return etat == Etat.REUSSI || etat == Etat.CACHE;
    }
}
