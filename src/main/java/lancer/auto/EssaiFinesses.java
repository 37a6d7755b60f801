package lancer.auto;

import java.util.Arrays;
import java.util.Collections;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;
import lancer.Couleur;
import lancer.contrat.Compteurs;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/**
 * Les échantillonnages, essayés sur quelques blocs tirés parmi ceux qui promettent de l'erreur ; puis, sur bien plus,
 * ceux qui semblent convenir.
 */
final class EssaiFinesses {

    private static final int TIRAGES = 120;
    private static final int TIRAGES_SURS = 640;

    /** Ce que tout bloc promet, en plus du contraste qu'on y voit, de 0 à 1 : aucun n'est à l'abri d'un détail. */
    private static final double IMPREVU = 0.1;

    /** Points où l'on cherche le contraste, sur le bloc et un demi-pixel autour. */
    private static final Reseau CONTRASTE = new Reseau(13);
    private static final double BORD = 0.5;
    private static final List<ToDoubleFunction<Couleur>> COMPOSANTES = Arrays.asList(c -> c.r, c -> c.v, c -> c.b);

    private final Essais essais;
    private final LimitesDesReflets limites;
    private final Reseau reseau;
    private final Epreuve premiere;
    private final Epreuve seconde;

    /** Rayons de toutes sortes pour un rayon de l'écran, là où les échantillonnages en ajoutent. */
    private double rayonsDesDetails;

    private EssaiFinesses(Essais essais, List<Pave> blocs, double[] promesses, LimitesDesReflets limites,
            Reseau reseau) {
        this.essais = essais;
        this.limites = limites;
        this.reseau = reseau;
        premiere = new Epreuve(new Tirage(TIRAGES, blocs, promesses, essais.facteur()));
        seconde = new Epreuve(new Tirage(TIRAGES_SURS, blocs, promesses, essais.facteur()));
    }

    /**
     * @param limites assez exactes pour que l'erreur vienne des échantillonnages
     * @param reseau les points des références, assez nombreux pour l'erreur à mesurer
     */
    static EssaiFinesses parmi(List<Pave> blocs, Essais essais, LimitesDesReflets limites, Reseau reseau) {
        return new EssaiFinesses(essais, blocs, promesses(essais, blocs, limites), limites, reseau);
    }

    /** Un tirage parmi ces blocs, pour une mesure sûre. */
    static Tirage tirer(Essais essais, List<Pave> blocs, LimitesDesReflets limites) {
        return new Tirage(TIRAGES_SURS, blocs, promesses(essais, blocs, limites), essais.facteur());
    }

    private static double[] promesses(Essais essais, List<Pave> blocs, LimitesDesReflets limites) {
        double[] promesses = new double[blocs.size()];
        essais.passer(blocs, limites.reflets, limites.seuil, (rang, b, pave, vue) -> {
            Couleur[] couleurs = new Couleur[CONTRASTE.points];
            for (int k = 0; k < couleurs.length; k++) {
                couleurs[k] = vue.couleur(b.i0 - BORD + CONTRASTE.x(k, 0) * (b.i1 - b.i0 + 2 * BORD),
                        b.j0 - BORD + CONTRASTE.y(k, 0) * (b.j1 - b.j0 + 2 * BORD));
            }
            promesses[rang] = IMPREVU + contraste(couleurs);
        });
        return promesses;
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

    /** Donne à chacune son erreur et son prix, à peu près. */
    void essayer(List<Finesse> finesses) {
        essayer(finesses, premiere);
    }

    /** Lui donne une erreur et un prix plus sûrs. */
    void approfondir(Finesse finesse) {
        essayer(Collections.singletonList(finesse), seconde);
    }

    private void essayer(List<Finesse> finesses, Epreuve epreuve) {
        Tirage tirage = epreuve.tirage;
        double[][] ecarts = new double[finesses.size()][tirage.blocs.size()];
        int[][] vus = new int[finesses.size()][tirage.blocs.size()];
        Compteurs compteurs = essais.passer(tirage.blocs, limites.reflets, limites.seuil, (rang, bloc, pave, vue) -> {
            Souvenir souvenir = new Souvenir(bloc, vue);
            for (int f = 0; f < finesses.size(); f++) {
                Niveaux niveaux = new Niveaux(bloc);
                finesses.get(f).echantillonnage.tracer(Essais.entoure(bloc, pave), souvenir, niveaux);
                ecarts[f][rang] = niveaux.ecart(epreuve.references(rang, vue));
                vus[f][rang] = souvenir.vus();
            }
        });
        if (rayonsDesDetails == 0) {
            rayonsDesDetails = (double) compteurs.rayons() / compteurs.primaires;
        }
        for (int f = 0; f < finesses.size(); f++) {
            double rayons = tirage.parPixel(vus[f]);
            // le premier rayon du pixel est comme tous ; les suivants vont là où il y a à voir
            double prix = Math.min(1, rayons) + Math.max(0, rayons - 1) * rayonsDesDetails / limites.rayons;
            finesses.get(f).noter(tirage.estimer(ecarts[f]), rayons, prix, epreuve == seconde);
        }
    }

    /** Nombre de pixels des essais sûrs. */
    int pixels() {
        return seconde.tirage.pixels();
    }

    /** Des blocs, et leurs références, faites au premier essai. */
    private final class Epreuve {

        private final Tirage tirage;
        private final Niveaux[][] references;

        Epreuve(Tirage tirage) {
            this.tirage = tirage;
            references = new Niveaux[tirage.blocs.size()][];
        }

        Niveaux[] references(int rang, Vue vue) {
            if (references[rang] == null) {
                references[rang] = Niveaux.references(tirage.blocs.get(rang), vue, reseau);
            }
            return references[rang];
        }
    }
}
