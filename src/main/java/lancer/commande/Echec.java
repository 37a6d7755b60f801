package lancer.commande;

/** Le programme ne peut pas faire ce qu'on lui demande : un message d'une ligne, et un statut de sortie. */
public class Echec extends RuntimeException {

    private static final long serialVersionUID = 1;

    private final int code;

    /** @param code {@link CodeSortie#PANNE} ou {@link CodeSortie#DEMANDE} */
    public Echec(int code, String message) {
        super(message);
        this.code = code;
    }

    public int getCode() {
        return code;
    }
}
