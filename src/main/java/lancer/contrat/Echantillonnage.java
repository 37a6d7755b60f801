package lancer.contrat;

/**
 * Choix des points de l'écran qui donnent les couleurs d'un pavé, au lieu du seul centre de chaque pixel. Les pixels
 * voisins d'un pavé partagent des points. Tous les fils appellent le même objet, qui n'a pas d'état.
 */
public interface Echantillonnage {

    /**
     * Dessine au moins les pixels voulus du pavé, chacun une fois. Leur couleur ne dépend que du pavé et de la vue.
     *
     * @param voulus une partie du pavé, ou tout le pavé
     * @return le nombre de pixels raffinés, 0 si l'échantillonnage n'en raffine pas
     */
    int tracer(Pave pave, Pave voulus, Vue vue, Toile toile);
}
