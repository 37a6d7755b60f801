package lancer.correction.jugement;

/** Résultat d'une vérification. */
public final class Verdict {

    /** États, du meilleur au pire. */
    public enum Etat {
        REUSSI("réussi"),
        /** La classe est juste, seule avec celles du corrigé ; une autre classe du rendu fait échouer la vérification. */
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

    /** Verdict d'un échec : raté, ou ne se compile pas, d'après le message. */
    static Verdict rate(String message) {
        return new Verdict(message.startsWith(JugeRendu.NE_SE_COMPILE_PAS) ? Etat.NE_SE_COMPILE_PAS : Etat.RATE, message);
    }

    /** Dit si la vérification échoue. */
    public boolean rate() {
        return etat == Etat.RATE || etat == Etat.NE_SE_COMPILE_PAS;
    }

    /** Dit si la vérification rapporte ses points. */
    public boolean compte() {
        return etat == Etat.REUSSI || etat == Etat.CACHE;
    }
}
