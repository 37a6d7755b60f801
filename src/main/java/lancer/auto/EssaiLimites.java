package lancer.auto;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Constantes;
import lancer.Couleur;
import lancer.contrat.Pave;

/** Les limites des reflets, essayées sur des rayons semés également : un au centre de chaque bloc. */
final class EssaiLimites {

    /** Profondeurs essayées ; le programme ne va pas plus loin que la dernière, qui passe pour exacte. */
    private static final int[] REFLETS = {0, 1, 2, 3, 4, 5, 7, 10, 15, 20, 30, 40, 60, 80, 120, 160, 240, 320, 480, 640,
            1000};
    private static final double[] SEUILS = {0, 1.0 / 4, 1.0 / 16, 1.0 / 64, 1.0 / 256, Constantes.SEUIL, 1.0 / 4096};

    /** Un écart que personne ne verra ni ne mesurera, en niveaux. */
    private static final double EXACT = 0.001;

    /** Entre lesquelles choisir : de moins en moins d'erreur, et de plus en plus de rayons. */
    final List<LimitesDesReflets> permises = new ArrayList<>();

    /** Où chaque rayon voit ce qu'il verrait sans limite. */
    final LimitesDesReflets exactes;

    private final Essais essais;
    private final List<Pave> blocs;
    private final Couleur[] sansLimite;

    /** De chaque rayon sans limite : ceux qu'il a fait lancer, lui compris. */
    private final double[] rayons;

    /**
     * Les rayons que des limites peuvent arrêter ; ceux qu'arrête le dernier essai, et son plus grand carré d'un écart,
     * en niveaux².
     */
    private final List<Integer> reflechis;
    private List<Integer> limites;
    private double pire;

    /** Essaie toutes celles que le souhait laisse à choisir. */
    EssaiLimites(Essais essais, List<Pave> blocs, Souhait souhait) {
        this.essais = essais;
        this.blocs = blocs;
        sansLimite = new Couleur[blocs.size()];
        rayons = new double[blocs.size()];
        limites = IntStream.range(0, blocs.size()).boxed().collect(Collectors.toList());
        voir(limites, REFLETS[REFLETS.length - 1], 0, sansLimite, rayons);
        List<LimitesDesReflets> toutes = new ArrayList<>();
        toutes.add(essayer(limites, REFLETS[0], 0));
        reflechis = limites;
        while (pire > EXACT * EXACT) {
            toutes.add(essayer(limites, REFLETS[toutes.size()], 0));
        }
        if (limites.isEmpty() && essais.reflechit()) {
            // un pas de plus ne coûte rien, et d'autres rayons le demandent peut-être
            toutes.set(toutes.size() - 1, essayer(limites, REFLETS[toutes.size()], 0));
        }
        exactes = toutes.get(toutes.size() - 1);
        int fin = souhait.reflets == null ? exactes.reflets : souhait.reflets;
        double premier = souhait.seuil == null ? SEUILS[0] : souhait.seuil;
        if (souhait.reflets != null || premier > 0) {
            toutes.clear();
            IntStream.of(REFLETS).filter(r -> souhait.reflets == null && r < fin)
                    .forEach(r -> toutes.add(essayer(r, premier)));
            toutes.add(essayer(fin, premier));
        }
        // sans reflets, tous les seuils se valent
        Arrays.stream(SEUILS).filter(seuil -> souhait.seuil == null && seuil > 0 && fin > 0)
                .forEach(seuil -> toutes.add(essayer(fin, seuil)));
        permettre(toutes);
    }

    LimitesDesReflets essayer(int reflets, double seuil) {
        return essayer(reflechis, reflets, seuil);
    }

    private void permettre(List<LimitesDesReflets> toutes) {
        toutes.sort(Comparator.comparingDouble((LimitesDesReflets l) -> l.rayons)
                .thenComparingDouble(l -> l.erreur.erreur()));
        double moindre = Double.POSITIVE_INFINITY;
        for (LimitesDesReflets l : toutes) {
            if (l.erreur.erreur() < moindre) {
                permises.add(l);
                moindre = l.erreur.erreur();
            }
        }
    }

    /** Met dans {@code couleurs} celle du centre de ces blocs, et dans {@code lances} les rayons qu'elle demande. */
    private void voir(List<Integer> rangs, int reflets, double seuil, Couleur[] couleurs, double[] lances) {
        List<Pave> vus = rangs.stream().map(blocs::get).collect(Collectors.toList());
        essais.passer(vus, new LimitesDesReflets(reflets, seuil, null, 0), (k, bloc, pave, vue) -> {
            long avant = vue.rayons();
            couleurs[rangs.get(k)] = vue.couleur((bloc.i0 + bloc.i1) / 2.0, (bloc.j0 + bloc.j1) / 2.0);
            lances[rangs.get(k)] = vue.rayons() - avant;
        });
    }

    /** @param rangs de tous les rayons que ces limites peuvent arrêter */
    private LimitesDesReflets essayer(List<Integer> rangs, int reflets, double seuil) {
        Couleur[] couleurs = sansLimite.clone();
        double[] lances = rayons.clone();
        voir(rangs, reflets, seuil, couleurs, lances);
        limites = rangs.stream().filter(k -> lances[k] < rayons[k]).collect(Collectors.toList());
        double[] carres = new double[couleurs.length];
        for (int k : rangs) {
            double[] vue = Niveaux.de(couleurs[k]);
            double[] juste = Niveaux.de(sansLimite[k]);
            for (int c = 0; c < 3; c++) {
                carres[k] += (vue[c] - juste[c]) * (vue[c] - juste[c]) / 3;
            }
        }
        pire = Arrays.stream(carres).max().getAsDouble();
        return new LimitesDesReflets(reflets, seuil, Estimation.de(carres),
                Arrays.stream(lances).average().getAsDouble());
    }
}
