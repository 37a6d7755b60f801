package lancer.correction;

/** Raison qui empêche de noter, en une ligne. */
public final class Panne extends RuntimeException {

    private static final long serialVersionUID = 1;

    /** Le statut de sortie : 1, la machine n'a pas pu ; 2, la demande était fausse. */
    public final int code;

    public Panne(int code, String message) {
        super(message);
        this.code = code;
    }
}
