package lancer.correction.isolement;

/** Arrêt d'un programme, forcé ou spontané, avant sa réponse. */
public final class Arret extends Exception {

    private static final long serialVersionUID = 1;

    /** Vrai si son statut est celui d'un programme que le système a tué ; un rendu peut se le donner. */
    public final boolean tue;

    public Arret(String cause, boolean tue) {
        super(cause);
        this.tue = tue;
    }
}
