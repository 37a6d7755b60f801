package lancer.auto;

import java.util.Collections;
import java.util.List;
import lancer.Couleur;
import lancer.contrat.Compteurs;

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

    private final Essais essais;
    private final Limites limites;
    private final Reseau reseau;
    private final Epreuve premiere;
    private final Epreuve seconde;

    /** Rayons de toutes sortes pour un rayon de l'écran, là où les échantillonnages en ajoutent. */
    private double rayonsDesDetails;

    /**
     * @param limites assez exactes pour que l'erreur vienne des échantillonnages
     * @param reseau les points des références, assez nombreux pour l'erreur à mesurer
     */
    EssaiFinesses(Essais essais, List<Bloc> blocs, Limites limites, Reseau reseau) {
        this.essais = essais;
        this.limites = limites;
        this.reseau = reseau;
        double[] promesses = promesses(essais, blocs, limites);
        premiere = new Epreuve(new Tirage(TIRAGES, blocs, promesses, essais.facteur()));
        seconde = new Epreuve(new Tirage(TIRAGES_SURS, blocs, promesses, essais.facteur()));
    }

    /** Un tirage parmi ces blocs, pour une mesure sûre. */
    static Tirage tirer(Essais essais, List<Bloc> blocs, Limites limites) {
        return new Tirage(TIRAGES_SURS, blocs, promesses(essais, blocs, limites), essais.facteur());
    }

    private static double[] promesses(Essais essais, List<Bloc> blocs, Limites limites) {
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
        double[] min = {1, 1, 1};
        double[] max = {0, 0, 0};
        for (Couleur couleur : couleurs) {
            double[] composantes = {couleur.r, couleur.v, couleur.b};
            for (int c = 0; c < min.length; c++) {
                double limitee = Math.max(0, Math.min(1, composantes[c]));
                min[c] = Math.min(min[c], limitee);
                max[c] = Math.max(max[c], limitee);
            }
        }
        return Math.max(max[0] - min[0], Math.max(max[1] - min[1], max[2] - min[2]));
    }

    /** Donne à chacune son erreur et son prix, à peu près. */
    void essayer(List<Finesse> finesses) {
        Compteurs compteurs = premiere.passer(finesses);
        if (rayonsDesDetails == 0) {
            rayonsDesDetails = (double) compteurs.rayons() / compteurs.primaires;
        }
        noter(premiere, finesses, false);
    }

    /** Lui donne une erreur et un prix plus sûrs. */
    void approfondir(Finesse finesse) {
        seconde.passer(Collections.singletonList(finesse));
        noter(seconde, Collections.singletonList(finesse), true);
    }

    /** Nombre de pixels des essais sûrs. */
    int pixels() {
        return seconde.tirage.pixels();
    }

    private void noter(Epreuve epreuve, List<Finesse> finesses, boolean sure) {
        for (int f = 0; f < finesses.size(); f++) {
            double rayons = epreuve.tirage.parPixel(epreuve.vus[f]);
            // le premier rayon du pixel est comme tous ; les suivants vont là où il y a à voir
            double prix = Math.min(1, rayons) + Math.max(0, rayons - 1) * rayonsDesDetails / limites.rayons;
            finesses.get(f).noter(epreuve.tirage.estimer(epreuve.ecarts[f]), rayons, prix, sure);
        }
    }

    /** Des blocs, leurs références, et ce qu'on y a mesuré en dernier. */
    private final class Epreuve {

        private final Tirage tirage;
        private final Releve[][] references;
        private double[][] ecarts;
        private int[][] vus;

        Epreuve(Tirage tirage) {
            this.tirage = tirage;
            references = new Releve[tirage.blocs.size()][];
        }

        Compteurs passer(List<Finesse> finesses) {
            ecarts = new double[finesses.size()][references.length];
            vus = new int[finesses.size()][references.length];
            return essais.passer(tirage.blocs, limites.reflets, limites.seuil, (rang, bloc, pave, vue) -> {
                if (references[rang] == null) {
                    references[rang] = Releve.references(bloc, vue, reseau);
                }
                Souvenir souvenir = new Souvenir(bloc, vue);
                for (int f = 0; f < finesses.size(); f++) {
                    Releve releve = new Releve(bloc);
                    finesses.get(f).getEchantillonnage().tracer(bloc.entoure(pave), souvenir, releve);
                    ecarts[f][rang] = releve.ecart(references[rang]);
                    vus[f][rang] = souvenir.vus();
                }
            });
        }
    }
}
