package lancer.contrat;

import java.util.List;
import lancer.Camera;
import lancer.Objet3D;

/**
 * Points de l'écran dont viennent les couleurs d'un pavé, s'il y faut plus que le centre de chaque pixel : un pavé
 * entier, où des voisins partagent des points. Appelé par tous les fils à la fois, un échantillonnage n'a pas d'état.
 */
public interface Echantillonnage {

    /**
     * Dessine au moins ces pixels du pavé, chacun une fois. Sa couleur ne dépend que du pavé et de la vue.
     *
     * @param voulus une partie du pavé, ou lui-même
     * @return le nombre de pixels qu'il a fallu raffiner, 0 si cela n'a pas de sens
     */
    int tracer(Pave pave, Pave voulus, Vue vue, Toile toile);

    /** Échantillonnage pour ces objets, vus de cette caméra : demandé à chaque dessin ; lui-même si rien n'y change. */
    default Echantillonnage pour(List<Objet3D> objets, Camera camera) {
        return this;
    }
}
