package lancer.commande;

/**
 * Le programme ne peut pas faire ce qu'on lui demande : un message d'une ligne, et un statut de sortie. Le statut est 0
 * si tout est fait ; après Ctrl+C, la machine virtuelle rend 130.
 */
public final class Echec extends RuntimeException {

    /** La machine n'a pas pu : disque plein, sortie impossible à écrire, mémoire épuisée, pas d'écran. */
    public static final int PANNE = 1;

    /** La demande était fausse : option, valeur, scène. */
    public static final int DEMANDE = 2;

    private static final long serialVersionUID = 1;

    /** Le statut de sortie. */
    public final int code;

    private Echec(int code, String message) {
        super(message);
        this.code = code;
    }

    public static Echec panne(String message) {
        return new Echec(PANNE, message);
    }

    public static Echec demande(String message) {
        return new Echec(DEMANDE, message);
    }
}
