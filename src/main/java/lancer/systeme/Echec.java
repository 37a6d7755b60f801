package lancer.systeme;

/** Échec du programme : un message d'une ligne, et un statut de sortie. */
public final class Echec extends RuntimeException {

    /** Statuts : la machine a échoué (disque, mémoire, écran), ou la demande est fausse (option, valeur, scène). */
    public static final int MACHINE = 1;
    public static final int DEMANDE = 2;

    private static final long serialVersionUID = 1;

    public final int code;

    private Echec(int code, String message) {
        super(message);
        this.code = code;
    }

    public static Echec machine(String message) {
        return new Echec(MACHINE, message);
    }

    public static Echec demande(String message) {
        return new Echec(DEMANDE, message);
    }
}
