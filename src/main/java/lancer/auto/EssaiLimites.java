package lancer.auto;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.DoubleSupplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Constantes;
import lancer.Couleur;
import lancer.contrat.Pave;

/** Les limites des reflets, essayées sur des rayons semés également : un au centre de chaque bloc. */
final class EssaiLimites {

    /** Profondeurs essayées ; le programme ne va pas plus loin que la dernière. */
    private static final int[] REFLETS = {0, 1, 2, 3, 4, 5, 7, 10, 15, 20, 30, 40, 60, 80, 120, 160, 240, 320, 480, 640,
            1000};
    private static final double[] SEUILS = {1.0 / 4, 1.0 / 16, 1.0 / 64, 1.0 / 256, Constantes.SEUIL, 1.0 / 4096};

    /** Un produit des Ks sous lequel un reflet ne se voit ni ne se mesure ; un tel écart, en niveaux. */
    private static final double SANS_LIMITE = 1e-9;
    private static final double EXACT = 0.001;

    /** Blocs où s'essaient les limites et se cherche le contraste, et les rayons que chacun y lance de l'écran. */
    private static final int BLOCS_MIN = 50;
    private static final int BLOCS_MAX = 3200;
    private static final int RAYONS_PAR_BLOC = 14;

    /** Entre lesquelles choisir : de moins en moins d'erreur, et de plus en plus de rayons. */
    final List<LimitesDesReflets> permises = new ArrayList<>();

    /** Sans limite, autant dire. */
    final LimitesDesReflets exactes;

    private final Essais essais;
    List<Pave> blocs;

    /** De chaque rayon sans limite : ce qu'il voit, et ceux qu'il a fait lancer, lui compris. */
    private double[][] justes;
    private double[] rayons;

    /** Les rayons que des limites peuvent arrêter. */
    private final List<Integer> reflechis;

    /** Essaie toutes celles que le souhait laisse à choisir, sur autant de blocs que tant de rayons le permettent. */
    EssaiLimites(Essais essais, Souhait souhait, DoubleSupplier permis) {
        this.essais = essais;
        int loin = REFLETS[REFLETS.length - 1];
        List<Integer> tous;
        int combien = BLOCS_MIN;
        do {
            blocs = essais.semer(combien, false);
            justes = new double[blocs.size()][];
            rayons = new double[justes.length];
            tous = IntStream.range(0, justes.length).boxed().collect(Collectors.toList());
            voir(tous, loin, SANS_LIMITE, justes, rayons);
            combien *= 2;
        } while (combien <= BLOCS_MAX && RAYONS_PAR_BLOC * combien * moyenne(rayons) <= permis.getAsDouble());
        exactes = new LimitesDesReflets(loin, SANS_LIMITE, new Estimation(0, 0), moyenne(rayons));
        double[] directs = new double[justes.length];
        voir(tous, 0, 0, new double[justes.length][], directs);
        reflechis = tous.stream().filter(k -> directs[k] < rayons[k]).collect(Collectors.toList());
        List<LimitesDesReflets> toutes = new ArrayList<>();
        boolean reflete = essais.prepare.getScene().getObjets().stream()
                .anyMatch(objet -> !objet.getKs().equals(new Couleur()));
        int[] profondeurs = souhait.reflets != null ? new int[] {souhait.reflets} : reflete ? REFLETS : new int[] {0};
        LimitesDesReflets avant = null;
        LimitesDesReflets l = null;
        // un pas de plus qui ne coûte rien se fait : d'autres rayons le demandent peut-être
        for (int k = 0; k < profondeurs.length
                && (avant == null || l.rayons > avant.rayons && l.erreur.erreur() > EXACT); k++) {
            avant = l;
            l = essayer(profondeurs[k], souhait.seuil == null ? 0 : souhait.seuil);
            toutes.add(l);
        }
        for (int k = 0; k < SEUILS.length && souhait.seuil == null && l.reflets > 0; k++) {
            toutes.add(essayer(l.reflets, SEUILS[k]));
        }
        toutes.sort(Comparator.<LimitesDesReflets>comparingDouble(limites -> limites.rayons)
                .thenComparingDouble(limites -> limites.erreur.erreur()).thenComparingInt(limites -> -limites.reflets));
        double moindre = Double.POSITIVE_INFINITY;
        for (LimitesDesReflets limites : toutes) {
            if (limites.erreur.erreur() < moindre) {
                permises.add(limites);
                moindre = limites.erreur.erreur();
            }
        }
    }

    LimitesDesReflets essayer(int reflets, double seuil) {
        double[][] vus = justes.clone();
        double[] lances = rayons.clone();
        voir(reflechis, reflets, seuil, vus, lances);
        double[] carres = new double[justes.length];
        for (int k : reflechis) {
            for (int c = 0; c < 3; c++) {
                carres[k] += (vus[k][c] - justes[k][c]) * (vus[k][c] - justes[k][c]) / 3;
            }
        }
        return new LimitesDesReflets(reflets, seuil, Estimation.de(carres), moyenne(lances));
    }

    /** Met dans {@code vus} ce qui se voit au centre de ces blocs, dans {@code lances} les rayons qu'il y faut. */
    private void voir(List<Integer> rangs, int reflets, double seuil, double[][] vus, double[] lances) {
        List<Pave> parmi = rangs.stream().map(blocs::get).collect(Collectors.toList());
        essais.passer(parmi, reflets, seuil, (k, bloc, pave, vue) -> {
            long avant = vue.rayons();
            vus[rangs.get(k)] = Niveaux.de(vue.couleur((bloc.i0 + bloc.i1) / 2.0, (bloc.j0 + bloc.j1) / 2.0));
            lances[rangs.get(k)] = vue.rayons() - avant;
        });
    }

    private static double moyenne(double[] comptes) {
        return Arrays.stream(comptes).average().getAsDouble();
    }
}
