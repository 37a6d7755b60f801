package lancer.auto;

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

    /** Rayons de l'écran que demandent, pour un bloc tiré, ses références et les essais qui se font contre elles. */
    private static final double RAYONS_PAR_TIRAGE = 1300;

    /** Ce que coûte de l'essayer, rapporté à ses pixels quand ils sont comme ceux de toute l'image. */
    private static final double ENTOURE = 6;

    /** Où commencent les tirages : ceux du prix ne sont pas ceux des erreurs. */
    private static final double DEBUT = 0.25;
    private static final double AUTRE_DEBUT = 0.75;

    private final Essais essais;
    private final LimitesDesReflets limites;
    final List<Pave> blocs;
    private final double[] promesses;
    private final Tirage tirage;
    private final References references;

    /**
     * @param limites sans limite, autant dire : l'erreur ne vient que des échantillonnages
     * @param rayons de toutes sortes, permis à ces essais
     */
    EssaiFinesses(Essais essais, List<Pave> blocs, LimitesDesReflets limites, double rayons) {
        this.essais = essais;
        this.blocs = blocs;
        this.limites = limites;
        promesses = Niveaux.promesses(essais, blocs, limites);
        tirage = new Tirage(rayons / (RAYONS_PAR_TIRAGE * limites.rayons), blocs, promesses, DEBUT);
        references = new References(essais, tirage.blocs, limites);
        references.affiner(Double.POSITIVE_INFINITY, rayons / 2);
    }

    /**
     * Donne à celle-ci son erreur et son prix.
     *
     * @param rayons permis à son dessin
     * @param reste ceux qui le sont ensuite à ce qui manque aux références, son prix étant connu
     * @return faux si les premiers ne suffisent pas ; ce qui est dit d'elle ne vaut alors rien
     */
    boolean essayer(Finesse finesse, double rayons, ToDoubleFunction<Finesse> reste) {
        Niveaux[] dessines = essais.borner(rayons, () -> dessiner(finesse, tirage, limites));
        if (dessines == null) {
            return false;
        }
        do {
            finesse.erreur = tirage.estimer(references.ecarts(dessines));
        } while (references.affiner(finesse.erreur.erreur(), reste.applyAsDouble(finesse)));
        return true;
    }

    /** Lui donne un prix plus sûr, sur autant de blocs que ces rayons le permettent, sous ces limites. */
    void chiffrer(Finesse finesse, LimitesDesReflets celles, double rayons) {
        double avant = finesse.prix;
        double parBloc = ENTOURE * Essais.COTE * Essais.COTE * avant * celles.rayons;
        Tirage autre = new Tirage(rayons / parBloc, blocs, promesses, AUTRE_DEBUT);
        if (essais.borner(rayons, () -> dessiner(finesse, autre, celles)) != null) {
            finesse.prix = (autre.tirages * finesse.prix + tirage.tirages * avant) / (autre.tirages + tirage.tirages);
        }
    }

    /** Dessine ces blocs, et donne à celle-ci son prix. */
    private Niveaux[] dessiner(Finesse finesse, Tirage parmi, LimitesDesReflets celles) {
        Niveaux[] dessines = new Niveaux[parmi.blocs.size()];
        double[] vus = new double[dessines.length];
        double[] lances = new double[dessines.length];
        essais.passer(parmi.blocs, (rang, bloc, fil) -> {
            Vue vue = fil.vue(celles.reflets, celles.seuil);
            dessines[rang] = new Niveaux(bloc);
            // ce qui entoure le bloc ne se compte pas
            Vue comptee = (xe, ye) -> {
                long avant = vue.rayons();
                Couleur couleur = vue.couleur(xe, ye);
                if (bloc.contient((int) Math.floor(xe), (int) Math.floor(ye))) {
                    vus[rang]++;
                    lances[rang] += vue.rayons() - avant;
                }
                return couleur;
            };
            finesse.echantillonnage.tracer(essais.entoure(bloc), bloc, comptee, dessines[rang]);
            // le premier rayon d'un pixel est comme tous ; les suivants vont là où il y a à voir
            lances[rang] *= 1 - bloc.pixels() / Math.max(1, vus[rang]);
        });
        finesse.rayons = parmi.parPixel(vus);
        finesse.prix = Math.min(1, finesse.rayons) + Math.max(0, parmi.parPixel(lances)) / celles.rayons;
        return dessines;
    }
}
