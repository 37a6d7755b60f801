package lancer.correction.jugement;

/** Ce qu'une vérification a donné. */
public final class Verdict {

    /** Du meilleur au pire. */
    public enum Etat {
        REUSSI("réussi"),
        /** La classe, seule parmi celles du corrigé, est juste ; une autre l'empêche de le montrer. */
        CACHE("juste, caché par une autre classe"),
        NON_EVALUABLE("non évaluable"),
        NON_COMMENCE("non commencé"),
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

    /** Vrai si la vérification rapporte ses points. */
    public boolean compte() {
        return etat == Etat.REUSSI || etat == Etat.CACHE;
    }
}
