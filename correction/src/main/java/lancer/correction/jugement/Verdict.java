package lancer.correction.jugement;

/** Résultat d'une vérification, et la classe en cause si elle échoue. */
public final class Verdict {

    /** États ; deux sont des reproches, ou leur absence : « fausse » et « non évaluable ». */
    public enum Etat {
        REUSSI("réussi"),
        /** Une extension rendue, dont l'enseignant donne les points. */
        A_NOTER("à noter"),
        NON_EVALUABLE("non évaluable"),
        NON_COMMENCE("non commencé"),
        FAUSSE("fausse");

        public final String texte;

        Etat(String texte) {
            this.texte = texte;
        }
    }

    public final Etat etat;
    /** La classe en cause, vide s'il n'y en a pas. */
    public final String classe;
    public final String message;

    public Verdict(Etat etat, String classe, String message) {
        this.etat = etat;
        this.classe = classe;
        this.message = message;
    }

    /** Dit si la vérification échoue. */
    public boolean rate() {
        return etat == Etat.FAUSSE;
    }

    /** Dit si la vérification rapporte ses points. */
    public boolean compte() {
        return etat == Etat.REUSSI;
    }
}
