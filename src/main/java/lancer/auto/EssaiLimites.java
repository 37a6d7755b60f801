package lancer.auto;

import java.util.ArrayList;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.commande.Options;
import lancer.contrat.Compteurs;

/** Les limites des reflets, essayées sur des rayons semés également. */
final class EssaiLimites {

    /** Profondeurs essayées ; le programme ne va pas plus loin que la dernière, qui passe pour exacte. */
    private static final int[] REFLETS = {0, 1, 2, 3, 4, 5, 7, 10, 15, 20, 30, 40, 60, 80, 120, 160, 240, 320, 480, 640,
            1000};
    private static final double[] SEUILS = {Constantes.SEUIL, 1.0 / 4, 1.0 / 16, 1.0 / 64, 1.0 / 256, 1.0 / 4096, 0};

    /** Un écart que personne ne verra ni ne mesurera, en niveaux. */
    private static final double EXACT = 0.001;

    /** Entre lesquelles choisir ; les moindres profondeurs d'abord. */
    final List<Limites> permises = new ArrayList<>();

    /** La moindre profondeur où tous les rayons semés voient ce qu'ils verraient sans limite. */
    final Limites exactes;

    private final Essais essais;
    private final List<Bloc> blocs;
    private final Couleur[] sansLimite;
    private boolean exact;

    /** @param options celles que l'utilisateur a données sont gardées */
    EssaiLimites(Essais essais, List<Bloc> blocs, Options options) {
        this.essais = essais;
        this.blocs = blocs;
        sansLimite = essais.centres(blocs, REFLETS[REFLETS.length - 1], 0, new Compteurs());
        List<Limites> profondeurs = new ArrayList<>();
        do {
            profondeurs.add(essayer(REFLETS[profondeurs.size()], 0));
        } while (!exact);
        exactes = profondeurs.get(profondeurs.size() - 1);
        List<Limites> choix = options.refletsDonnes ? new ArrayList<>() : profondeurs;
        if (options.refletsDonnes) {
            choix.add(essayer(options.reflets, 0));
        }
        List<Limites> seuils = seuils(options);
        for (Limites profondeur : choix) {
            for (Limites seuil : seuils) {
                permises.add(profondeur.et(seuil));
            }
        }
    }

    private List<Limites> seuils(Options options) {
        List<Limites> seuils = new ArrayList<>();
        for (double seuil : options.seuilDonne ? new double[] {options.seuil} : SEUILS) {
            seuils.add(essayer(exactes.reflets, seuil));
            if (exactes.reflets == 0) {
                // sans reflets, tous se valent
                break;
            }
        }
        return seuils;
    }

    private Limites essayer(int reflets, double seuil) {
        Compteurs compteurs = new Compteurs();
        Couleur[] couleurs = essais.centres(blocs, reflets, seuil, compteurs);
        double[] carres = new double[couleurs.length];
        exact = true;
        for (int k = 0; k < carres.length; k++) {
            double r = Releve.niveau(couleurs[k].r) - Releve.niveau(sansLimite[k].r);
            double v = Releve.niveau(couleurs[k].v) - Releve.niveau(sansLimite[k].v);
            double b = Releve.niveau(couleurs[k].b) - Releve.niveau(sansLimite[k].b);
            carres[k] = (r * r + v * v + b * b) / 3;
            exact &= carres[k] <= EXACT * EXACT;
        }
        return new Limites(reflets, seuil, Estimation.de(carres), (double) compteurs.rayons() / compteurs.primaires);
    }
}
