package lancer.auto;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleSupplier;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/** Les limites des reflets, essayées sur des rayons semés également : un au centre de chaque bloc. */
final class EssaiLimites {

    /** Profondeurs essayées ; le programme ne va pas plus loin que la dernière. */
    private static final int[] REFLETS = {0, 1, 2, 3, 4, 5, 7, 10, 15, 20, 30, 40, 60, 80, 120, 160, 240, 320, 480, 640,
            1000};
    private static final double[] SEUILS = {1.0 / 4, 1.0 / 16, 1.0 / 64, 1.0 / 256, Constantes.SEUIL, 1.0 / 4096};

    /** Un produit des Ks sous lequel un reflet ne se voit ni ne se mesure. */
    private static final double SANS_LIMITE = 1e-9;

    /** Blocs où s'essaient les limites et se cherche le contraste, et les rayons que chacun y lance de l'écran. */
    private static final int BLOCS_MIN = 50;
    private static final int BLOCS_MAX = 3200;
    private static final int RAYONS_PAR_BLOC = 14;

    /** Combien de fois plus de blocs que dans la passe d'avant. */
    private static final int PAS = 8;

    /** Entre lesquelles choisir : de moins en moins d'erreur, et de plus en plus de rayons. */
    final List<LimitesDesReflets> permises = new ArrayList<>();

    /** Sans limite, autant dire. */
    final LimitesDesReflets exactes;

    private final Essais essais;
    List<Pave> blocs;

    /** De chaque rayon sans limite : ce qu'il voit, et ceux qu'il a fait lancer, lui compris. */
    private double[][] justes;
    private double[] rayons;

    /** Essaie toutes celles que le souhait laisse à choisir, sur autant de blocs que tant de rayons le permettent. */
    EssaiLimites(Essais essais, Souhait souhait, DoubleSupplier permis) {
        this.essais = essais;
        int loin = REFLETS[REFLETS.length - 1];
        int combien = BLOCS_MIN;
        int faits;
        do {
            faits = combien;
            blocs = essais.semer(faits, false);
            justes = new double[blocs.size()][];
            rayons = new double[justes.length];
            essais.passer(blocs, (k, bloc, fil) -> {
                Vue vue = fil.vue(loin, SANS_LIMITE);
                long avant = vue.rayons();
                justes[k] = voir(bloc, vue);
                rayons[k] = vue.rayons() - avant;
            });
            // peu de blocs disent mal ce que les autres coûtent
            combien = (int) Math.min(Math.min(BLOCS_MAX, PAS * faits),
                    permis.getAsDouble() / (RAYONS_PAR_BLOC * Estimation.moyenne(rayons)));
        } while (combien > 2 * faits);
        exactes = new LimitesDesReflets(loin, SANS_LIMITE, new Estimation(0, 0), Estimation.moyenne(rayons));
        boolean reflete = false;
        for (Objet3D objet : essais.prepare.getScene().getObjets()) {
            reflete |= !objet.getKs().equals(new Couleur());
        }
        int[] profondeurs = souhait.reflets != null ? new int[] {souhait.reflets} : reflete ? REFLETS : new int[] {0};
        double[] seuils = new double[profondeurs.length];
        Arrays.fill(seuils, souhait.seuil == null ? 0 : souhait.seuil);
        List<LimitesDesReflets> toutes = essayer(profondeurs, seuils);
        if (souhait.seuil == null && profondeurs[profondeurs.length - 1] > 0) {
            int[] derniere = new int[SEUILS.length];
            Arrays.fill(derniere, profondeurs[profondeurs.length - 1]);
            toutes.addAll(essayer(derniere, SEUILS));
        }
        Collections.sort(toutes);
        double moindre = Double.POSITIVE_INFINITY;
        for (LimitesDesReflets limites : toutes) {
            if (limites.erreur.erreur() < moindre) {
                permises.add(limites);
                moindre = limites.erreur.erreur();
            }
        }
    }

    LimitesDesReflets essayer(int reflets, double seuil) {
        return essayer(new int[] {reflets}, new double[] {seuil}).get(0);
    }

    /** Essaie ces limites en une passe, de moins en moins étroites : un rayon qui va à son bout n'est pas refait. */
    private List<LimitesDesReflets> essayer(int[] reflets, double[] seuils) {
        double[][] carres = new double[reflets.length][justes.length];
        double[][] lances = new double[reflets.length][justes.length];
        essais.passer(blocs, (k, bloc, fil) -> {
            double[] vus = justes[k];
            double combien = 0;
            for (int l = 0; l < reflets.length; l++) {
                if (combien < rayons[k]) {
                    Vue vue = fil.vue(reflets[l], seuils[l]);
                    long avant = vue.rayons();
                    vus = voir(bloc, vue);
                    combien = vue.rayons() - avant;
                }
                lances[l][k] = combien;
                for (int c = 0; c < 3; c++) {
                    double ecart = vus[c] - justes[k][c];
                    carres[l][k] += ecart * ecart / 3;
                }
            }
        });
        List<LimitesDesReflets> essayees = new ArrayList<>();
        for (int l = 0; l < reflets.length; l++) {
            essayees.add(new LimitesDesReflets(reflets[l], seuils[l], Estimation.de(carres[l]),
                    Estimation.moyenne(lances[l])));
        }
        return essayees;
    }

    /** Ce qui se voit au centre de ce bloc. */
    private static double[] voir(Pave bloc, Vue vue) {
        return Niveaux.de(vue.couleur((bloc.i0 + bloc.i1) / 2.0, (bloc.j0 + bloc.j1) / 2.0));
    }
}
