package lancer.auto;

import java.util.Arrays;
import java.util.List;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Toile;

/**
 * Une toile devant une autre, qui retient au passage les pixels de quelques blocs, et y mesure ensuite l'image : sur
 * des blocs tirés parmi ceux-ci, d'autant plus volontiers qu'on y voit du contraste.
 */
final class Controle implements Toile {

    private final Toile toile;
    private final Essais essais;
    private final List<Pave> blocs;

    /** Les pixels des blocs à retenir, {@code null} pour les autres ; la table ne change pas pendant un dessin. */
    private final Niveaux[] niveaux;

    private Tirage tirage;

    Controle(Toile toile, Essais essais, List<Pave> blocs) {
        this.toile = toile;
        this.essais = essais;
        this.blocs = blocs;
        niveaux = new Niveaux[essais.blocs()];
        for (Pave bloc : blocs) {
            niveaux[essais.rang(bloc.i0, bloc.j0)] = new Niveaux(bloc);
        }
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        toile.drawPixel(coul, xe, ye);
        Niveaux retenus = niveaux[essais.rang(xe, ye)];
        if (retenus != null) {
            retenus.drawPixel(coul, xe, ye);
        }
    }

    /** L'erreur de la dernière image dessinée. @param attendue en niveaux ; {@code rayons} permis, de toutes sortes */
    Estimation mesurer(LimitesDesReflets exactes, double attendue, double rayons) {
        double[] promesses = new double[blocs.size()];
        Arrays.setAll(promesses, k -> Niveaux.promesse(de(blocs.get(k)).niveaux));
        double parBloc = 2 * Essais.COTE * Essais.COTE * References.pointsPour(attendue) * exactes.rayons;
        tirage = new Tirage(rayons / parBloc, blocs, promesses, 0.5);
        References references = new References(essais, tirage.blocs, exactes);
        double fin = essais.rayons() + rayons;
        // les premiers points disent ce que coûtent les autres
        references.affiner(Double.POSITIVE_INFINITY, rayons / 4);
        references.affiner(attendue, fin - essais.rayons());
        Niveaux[] dessines = new Niveaux[tirage.blocs.size()];
        Arrays.setAll(dessines, k -> de(tirage.blocs.get(k)));
        return tirage.estimer(references.ecarts(dessines));
    }

    private Niveaux de(Pave bloc) {
        return niveaux[essais.rang(bloc.i0, bloc.j0)];
    }

    /** Nombre de pixels où l'erreur est mesurée. */
    int pixels() {
        return Essais.pixels(tirage.blocs);
    }
}
