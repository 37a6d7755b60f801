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

    /** Vrai si la vérification rapporte ses points. */
    public boolean compte() {
        return part == 1;
    }
}
