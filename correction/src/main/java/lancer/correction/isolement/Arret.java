package lancer.correction.isolement;

/** Un programme qu'il a fallu arrêter, ou qui s'est arrêté de lui-même, avant d'avoir répondu. */
public final class Arret extends Exception {

    private static final long serialVersionUID = 1;

    /** Vrai si un autre que nous l'a tué. */
    public final boolean tue;

    public Arret(String cause, boolean tue) {
        super(cause);
        this.tue = tue;
    }
}
