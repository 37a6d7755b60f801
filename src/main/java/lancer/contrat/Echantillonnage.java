package lancer.contrat;

/**
 * Des points de l'écran aux pixels : où prendre la couleur de chaque pixel d'un pavé. Un pavé entier à la fois, pour que des
 * pixels voisins puissent partager des points. Appelé par tous les fils à la fois : un échantillonnage n'a pas d'état.
 */
public interface Echantillonnage {

    /** L'échantillonnage de la base : un rayon par pixel, en son centre. */
    Echantillonnage CENTRE = new Centre();

    /**
     * Dessine chaque pixel du pavé, une fois. Le résultat ne dépend que du pavé et de la vue.
     *
     * @return le nombre de pixels qu'il a fallu raffiner, 0 si cela n'a pas de sens
     */
    int tracer(Pave pave, Vue vue, Toile toile);

    /** Un rayon au centre de chaque pixel. */
    final class Centre implements Echantillonnage {
        @Override
        public int tracer(Pave pave, Vue vue, Toile toile) {
            for (int j = pave.j0; j < pave.j1; j++) {
                for (int i = pave.i0; i < pave.i1; i++) {
                    toile.drawPixel(vue.couleur(i + 0.5, j + 0.5), i, j);
                }
            }
            return 0;
        }
    }
}
