package lancer.correction.jugement;

import java.util.Objects;

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
    /** Ce que dit le compilateur, vide s'il ne se sait pas ; {@code null} si ce n'est pas une faute de compilation. */
    final String faute;
    /** La méthode de cette classe qui n'est pas commencée, vide si ce n'est pas ce que dit la vérification. */
    final transient String methode;

    public Verdict(Etat etat, String classe, String message) {
        this(etat, classe, message, null, "");
    }

    Verdict(Etat etat, String classe, String message, String faute, String methode) {
        this.etat = etat;
        this.classe = classe;
        this.message = Objects.requireNonNull(message);
        this.faute = faute;
        this.methode = methode;
    }

    /** Dit si la méthode vérifiée ne se compile pas. */
    public boolean neSeCompilePas() {
        return faute != null;
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
