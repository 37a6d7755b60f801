package lancer.contrat;

import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Objet3D;

/**
 * Passage des points de l'écran aux pixels : où prendre la couleur de chaque pixel d'un pavé. Un pavé entier à la fois,
 * pour que des pixels voisins puissent partager des points. Appelé par tous les fils à la fois : un échantillonnage
 * n'a pas d'état.
 */
public interface Echantillonnage {

    /** L'échantillonnage de la base : un rayon par pixel, en son centre. */
    Echantillonnage CENTRE = new Carres(1);

    /** Échantillonnage du brouillon, seize fois moins cher. */
    Echantillonnage BROUILLON = new Carres(Constantes.PAS_BROUILLON);

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

    /** Un rayon au centre de chaque carré de tant de pixels ; sur les bords, de sa part qui est dans l'image. */
    final class Carres implements Echantillonnage {

        private final int pas;

        private Carres(int pas) {
            this.pas = pas;
        }

        @Override
        public int tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
            Pave dessines = pas == 1 ? voulus : pave;
            for (int j = dessines.j0; j < dessines.j1; j += pas) {
                int jFin = Math.min(j + pas, dessines.j1);
                for (int i = dessines.i0; i < dessines.i1; i += pas) {
                    int iFin = Math.min(i + pas, dessines.i1);
                    peindre(vue.couleur((i + iFin) / 2.0, (j + jFin) / 2.0), i, j, iFin, jFin, toile);
                }
            }
            return 0;
        }

        /** Peint un carré. À part : la machine virtuelle le compile une fois, et non avec chaque boucle. */
        private static void peindre(Couleur couleur, int i, int j, int iFin, int jFin, Toile toile) {
            for (int y = j; y < jFin; y++) {
                for (int x = i; x < iFin; x++) {
                    toile.drawPixel(couleur, x, y);
                }
            }
        }
    }
}
