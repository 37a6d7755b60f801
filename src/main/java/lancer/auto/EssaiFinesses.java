package lancer.auto;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/**
 * Les échantillonnages, essayés sur quelques blocs tirés parmi ceux qui promettent de l'erreur, contre des références
 * d'autant plus fines que l'erreur à mesurer est petite. Rien n'y dépend de ce qui est voulu.
 */
final class EssaiFinesses {

    /** Points où l'on cherche le contraste, sur le bloc et un demi-pixel autour. */
    static final int POINTS = 8;
    private static final double BORD = 0.5;

    /** Ce que tout bloc promet, en plus du contraste qu'on y voit, de 0 à 1 : aucun n'est à l'abri d'un détail. */
    private static final double IMPREVU = 0.1;
    private static final double UNI = 0.3;

    /** Blocs tirés : au moins, quoi qu'il en coûte, et au plus, même si l'image permet davantage. */
    private static final int TIRAGES_MIN = 40;
    private static final int TIRAGES_MAX = 640;

    /** D'autres blocs, ou des références plus fines, ne se justifient que s'il y en a nettement plus. */
    private static final double NETTEMENT = 1.7;

    /** Rayons de l'écran que demandent, pour un bloc, les essais qui se font contre les mêmes références. */
    private static final int RAYONS_DES_ESSAIS = 150;
    private static final int RAYONS_D_UN_ESSAI = 40;

    private static final List<ToDoubleFunction<Couleur>> COMPOSANTES = Arrays.asList(c -> c.r, c -> c.v, c -> c.b);

    private final Essais essais;
    private final LimitesDesReflets limites;
    private final List<Pave> blocs;
    private final double[] promesses;

    /** Rayons de toutes sortes pour un rayon de l'écran, sous ces limites. */
    private final double rayonsParRayon;

    private int points;
    private Tirage tirage;
    private Niveaux[][] references;

    /** @param limites assez exactes pour que l'erreur vienne des échantillonnages */
    EssaiFinesses(Essais essais, List<Pave> blocs, LimitesDesReflets limites) {
        this.essais = essais;
        this.blocs = blocs;
        this.limites = limites;
        promesses = new double[blocs.size()];
        double[] lances = new double[blocs.size()];
        essais.passer(blocs, limites, (rang, b, pave, vue) -> {
            long avant = vue.rayons();
            Couleur[] couleurs = new Couleur[POINTS];
            for (int k = 0; k < POINTS; k++) {
                couleurs[k] = vue.couleur(b.i0 - BORD + Niveaux.x(k, 0) * (b.i1 - b.i0 + 2 * BORD),
                        b.j0 - BORD + Niveaux.y(k, 0) * (b.j1 - b.j0 + 2 * BORD));
            }
            promesses[rang] = IMPREVU + contraste(couleurs);
            lances[rang] = vue.rayons() - avant;
        });
        rayonsParRayon = Arrays.stream(lances).average().getAsDouble() / POINTS;
    }

    /** Le plus grand écart, sur une composante, entre ces couleurs limitées : de 0 à 1. */
    private static double contraste(Couleur[] couleurs) {
        double contraste = 0;
        for (ToDoubleFunction<Couleur> composante : COMPOSANTES) {
            DoubleSummaryStatistics vues = Arrays.stream(couleurs).mapToDouble(composante).summaryStatistics();
            contraste = Math.max(contraste, Niveaux.limite(vues.getMax()) - Niveaux.limite(vues.getMin()));
        }
        return contraste;
    }

    /** Rayons de toutes sortes pour un rayon de l'écran, sous d'autres limites. */
    double rayonsParRayon(LimitesDesReflets autres) {
        return rayonsParRayon * autres.rayons / limites.rayons;
    }

    /** Les rayons que devrait demander un essai. */
    double prochain() {
        return tirage.tirages * RAYONS_D_UN_ESSAI * rayonsParRayon;
    }

    Tirage tirage() {
        return tirage;
    }

    /**
     * Tire des blocs où mesurer une erreur de cet ordre, autant que ces rayons le permettent.
     *
     * @return faux si ceux qui sont tirés y suffisent déjà, ou presque
     */
    boolean affiner(double erreur, double rayons) {
        int fins = Math.max(points, Niveaux.pointsPour(erreur));
        double parBloc = rayonsParRayon * (2 * Essais.COTE * Essais.COTE * fins + RAYONS_DES_ESSAIS);
        int tirages = (int) Math.max(TIRAGES_MIN, Math.min(TIRAGES_MAX, rayons / parBloc));
        if (tirage != null && fins < NETTEMENT * points && tirages < NETTEMENT * tirage.tirages) {
            return false;
        }
        points = fins;
        tirage = new Tirage(tirages, blocs, promesses, essais.facteur());
        references = new Niveaux[tirage.blocs.size()][];
        return true;
    }

    /** Donne à celle-ci son erreur et son prix. */
    void essayer(Finesse finesse) {
        double[] ecarts = new double[tirage.blocs.size()];
        dessiner(finesse, tirage, limites, ecarts);
        finesse.erreur = tirage.estimer(ecarts);
    }

    /** Lui donne un prix plus sûr, sur autant de blocs que ces rayons le permettent, sous ces limites. */
    void chiffrer(Finesse finesse, LimitesDesReflets celles, double rayons) {
        double avant = finesse.prix;
        int tirages = (int) Math.min(TIRAGES_MAX, rayons / (rayonsParRayon(celles) * avant * RAYONS_D_UN_ESSAI));
        if (tirages > TIRAGES_MIN) {
            // un bloc uni coûte aussi, même s'il ne promet pas d'erreur
            double[] couts = Arrays.stream(promesses).map(promesse -> UNI + promesse).toArray();
            dessiner(finesse, new Tirage(tirages, blocs, couts, essais.facteur()), celles, null);
            finesse.prix = (tirages * finesse.prix + tirage.tirages * avant) / (tirages + tirage.tirages);
        }
    }

    /** @param ecarts à remplir ; {@code null} si seul le prix importe */
    private void dessiner(Finesse finesse, Tirage parmi, LimitesDesReflets celles, double[] ecarts) {
        double[] vus = new double[parmi.blocs.size()];
        double[] ajoutes = new double[vus.length];
        essais.passer(parmi.blocs, celles, (rang, bloc, pave, vue) -> {
            Niveaux niveaux = new Niveaux(bloc);
            Decompte decompte = new Decompte(bloc, vue);
            finesse.echantillonnage.tracer(Essais.entoure(bloc, pave, finesse.echantillonnage), decompte, niveaux);
            vus[rang] = decompte.points;
            // le premier rayon d'un pixel est comme tous ; les suivants vont là où il y a à voir
            ajoutes[rang] = decompte.rayons * (1 - bloc.pixels() / Math.max(1.0, decompte.points));
            if (ecarts != null) {
                references[rang] = references[rang] == null ? Niveaux.references(bloc, vue, points) : references[rang];
                ecarts[rang] = niveaux.ecart(references[rang]);
            }
        });
        finesse.rayons = parmi.parPixel(vus);
        finesse.prix = Math.min(1, finesse.rayons) + Math.max(0, parmi.parPixel(ajoutes)) / rayonsParRayon(celles);
    }

    /** L'erreur de ce qu'un prélèvement retient de ces blocs. */
    Estimation mesurer(Prelevement prelevement) {
        double[] ecarts = new double[tirage.blocs.size()];
        essais.passer(tirage.blocs, limites, (rang, bloc, pave, vue) ->
                ecarts[rang] = prelevement.de(bloc).ecart(Niveaux.references(bloc, vue, points)));
        return tirage.estimer(ecarts);
    }

    /** Une vue qui compte les points demandés dans un bloc, et les rayons de toutes sortes que cela fait lancer. */
    private static final class Decompte implements Vue {

        private final Vue vue;
        private final Pave bloc;
        private int points;
        private long rayons;

        Decompte(Pave bloc, Vue vue) {
            this.bloc = bloc;
            this.vue = vue;
        }

        @Override
        public Couleur couleur(double xe, double ye) {
            long avant = vue.rayons();
            Couleur couleur = vue.couleur(xe, ye);
            if (bloc.contient((int) Math.floor(xe), (int) Math.floor(ye))) {
                points++;
                rayons += vue.rayons() - avant;
            }
            return couleur;
        }
    }
}
