package lancer.auto;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.Couleur;
import lancer.contrat.Toile;

/** Une toile devant une autre, qui retient au passage les pixels de quelques blocs. */
final class Temoin implements Toile {

    private final Toile toile;
    private final int largeur;
    private final Releve[] releves;

    /** Les pixels à retenir, et pour chacun le rang de son bloc ; rien n'y change pendant un dessin. */
    private final BitSet retenus = new BitSet();
    private final Map<Integer, Integer> rangs = new HashMap<>();

    Temoin(Toile toile, int largeur, List<Bloc> blocs) {
        this.toile = toile;
        this.largeur = largeur;
        releves = new Releve[blocs.size()];
        for (int k = 0; k < releves.length; k++) {
            Bloc bloc = blocs.get(k);
            releves[k] = new Releve(bloc);
            for (int j = bloc.j0; j < bloc.j1; j++) {
                for (int i = bloc.i0; i < bloc.i1; i++) {
                    retenus.set(j * largeur + i);
                    rangs.put(j * largeur + i, k);
                }
            }
        }
    }

    /** Les pixels d'un bloc, dans la dernière image dessinée. */
    Releve releve(int rang) {
        return releves[rang];
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        toile.drawPixel(coul, xe, ye);
        int k = ye * largeur + xe;
        if (retenus.get(k)) {
            releves[rangs.get(k)].drawPixel(coul, xe, ye);
        }
    }
}
