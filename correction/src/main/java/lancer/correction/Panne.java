package lancer.correction;

/** Échec qui empêche de juger ou de noter, en une ligne. */
public final class Panne extends RuntimeException {

    private static final long serialVersionUID = 1;

    /** Le statut de sortie : 1 si la machine a échoué ; 2 si la demande est fausse. */
    public final int code;

    public Panne(int code, String message) {
        super(message);
        this.code = code;
    }
}
