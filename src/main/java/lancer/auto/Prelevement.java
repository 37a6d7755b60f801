package lancer.auto;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Toile;

/** Une toile devant une autre, qui retient au passage les pixels de quelques blocs. */
final class Prelevement implements Toile {

    private final Toile toile;
    private final int largeur;

    /** Les blocs à retenir, et leurs pixels ; la table n'est lue que là, et n'y change pas pendant un dessin. */
    private final BitSet retenus = new BitSet();
    private final Map<Integer, Niveaux> niveaux = new HashMap<>();

    Prelevement(Toile toile, int largeur, List<Pave> blocs) {
        this.toile = toile;
        this.largeur = largeur;
        for (Pave bloc : blocs) {
            retenus.set(numero(bloc.i0, bloc.j0));
            niveaux.put(numero(bloc.i0, bloc.j0), new Niveaux(bloc));
        }
    }

    private int numero(int i, int j) {
        return j / Essais.COTE * largeur + i / Essais.COTE;
    }

    /** Les pixels d'un des blocs, dans la dernière image dessinée. */
    Niveaux de(Pave bloc) {
        return niveaux.get(numero(bloc.i0, bloc.j0));
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        toile.drawPixel(coul, xe, ye);
        int k = numero(xe, ye);
        if (retenus.get(k)) {
            niveaux.get(k).drawPixel(coul, xe, ye);
        }
    }
}
