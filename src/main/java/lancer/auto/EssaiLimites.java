package lancer.auto;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.contrat.Compteurs;
import lancer.contrat.Pave;

/** Les limites des reflets, essayées sur des rayons semés également. */
final class EssaiLimites {

    /** Profondeurs essayées ; le programme ne va pas plus loin que la dernière, qui passe pour exacte. */
    private static final int[] REFLETS = {0, 1, 2, 3, 4, 5, 7, 10, 15, 20, 30, 40, 60, 80, 120, 160, 240, 320, 480, 640,
            1000};
    private static final double[] SEUILS = {Constantes.SEUIL, 1.0 / 4, 1.0 / 16, 1.0 / 64, 1.0 / 256, 1.0 / 4096, 0};

    /** Un écart que personne ne verra ni ne mesurera, en niveaux. */
    private static final double EXACT = 0.001;

    /** Entre lesquelles choisir ; les moindres profondeurs d'abord. */
    final List<LimitesDesReflets> permises = new ArrayList<>();

    /** La moindre profondeur où tous les rayons semés voient ce qu'ils verraient sans limite. */
    LimitesDesReflets exactes;

    private final Essais essais;
    private final List<Pave> blocs;
    private final Couleur[] sansLimite;

    /** Le plus grand carré d'un écart, dans le dernier essai, en niveaux². */
    private double pire;

    EssaiLimites(Essais essais, List<Pave> blocs) {
        this.essais = essais;
        this.blocs = blocs;
        sansLimite = new Couleur[blocs.size()];
    }

    /** Essaie toutes celles que le souhait laisse à choisir. */
    void essayer(Souhait souhait) {
        voir(sansLimite, REFLETS[REFLETS.length - 1], 0);
        List<LimitesDesReflets> profondeurs = new ArrayList<>();
        do {
            exactes = essayer(REFLETS[profondeurs.size()], 0);
            profondeurs.add(exactes);
        } while (pire > EXACT * EXACT);
        if (souhait.reflets != null) {
            profondeurs = Collections.singletonList(essayer(souhait.reflets, 0));
        }
        List<LimitesDesReflets> seuils = new ArrayList<>();
        for (double seuil : souhait.seuil == null ? SEUILS : new double[] {souhait.seuil}) {
            // sans reflets, tous se valent
            if (seuils.isEmpty() || exactes.reflets > 0) {
                seuils.add(essayer(exactes.reflets, seuil));
            }
        }
        profondeurs.forEach(profondeur -> seuils.forEach(seuil -> permises.add(profondeur.et(seuil))));
    }

    /** Met dans {@code couleurs} celle du centre de chaque bloc. */
    private Compteurs voir(Couleur[] couleurs, int reflets, double seuil) {
        return essais.passer(blocs, reflets, seuil, (rang, bloc, pave, vue) ->
                couleurs[rang] = vue.couleur((bloc.i0 + bloc.i1) / 2.0, (bloc.j0 + bloc.j1) / 2.0));
    }

    private LimitesDesReflets essayer(int reflets, double seuil) {
        Couleur[] couleurs = new Couleur[blocs.size()];
        Compteurs compteurs = voir(couleurs, reflets, seuil);
        double[] carres = new double[couleurs.length];
        for (int k = 0; k < carres.length; k++) {
            double[] vue = Niveaux.de(couleurs[k]);
            double[] juste = Niveaux.de(sansLimite[k]);
            for (int c = 0; c < 3; c++) {
                carres[k] += (vue[c] - juste[c]) * (vue[c] - juste[c]);
            }
            carres[k] /= 3;
        }
        pire = Arrays.stream(carres).max().getAsDouble();
        double rayons = (double) compteurs.rayons() / compteurs.primaires;
        return new LimitesDesReflets(reflets, seuil, Estimation.de(carres), rayons);
    }
}
