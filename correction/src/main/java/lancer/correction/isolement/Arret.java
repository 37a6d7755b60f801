package lancer.correction.isolement;

/** Un programme qu'il a fallu arrêter, ou qui s'est arrêté de lui-même, avant d'avoir répondu. */
public final class Arret extends Exception {

    private static final long serialVersionUID = 1;

    /** Vrai si rien ne l'a arrêté. */
    public final boolean deLuiMeme;

    public Arret(String cause, boolean deLuiMeme) {
        super(cause);
        this.deLuiMeme = deLuiMeme;
    }
}
