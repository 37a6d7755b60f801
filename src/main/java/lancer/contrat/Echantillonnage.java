package lancer.contrat;

/**
 * Choix des points de l'écran qui donnent les couleurs d'un pavé, au lieu du seul centre de chaque pixel. Les pixels
 * voisins d'un pavé partagent des points. Tous les fils appellent le même objet, qui n'a pas d'état.
 */
public interface Echantillonnage {

    /**
     * Dessine au moins les pixels voulus du pavé, chacun une fois. Leur couleur ne dépend que du pavé et de la vue, qui
     * dit si c'est un second regard ({@link Vue#estSeconde}).
     *
     * @param partie les pixels voulus : un rectangle du pavé, ou tout le pavé
     * @return {@link Releve#RIEN} si l'échantillonnage ne raffine aucun pixel
     */
    Releve tracer(Pave pave, Pave partie, Vue vue, Toile toile);
}
