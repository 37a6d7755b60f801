package lancer.auto;

import java.util.List;
import lancer.Lancer;
import lancer.commande.Options;
import lancer.contrat.Toile;
import lancer.contrat.Variante;

/**
 * {@code --auto} : choisit comment dessiner une scène, d'après quelques pixels essayés de toutes les façons permises,
 * et contrôle ensuite l'image sur d'autres. L'erreur est celle d'{@link Estimation}, contre la moyenne du pixel sans
 * limite de réflexions ; le prix se compte en rayons. Pour une erreur voulue, le choix ne dépend que de la scène, de la
 * taille et de ce qui est voulu ou fixé ; pour un temps voulu, il dépend aussi de la machine. Le brouillon n'est jamais
 * choisi : ce n'est pas une image.
 */
public final class Auto {

    /** Échantillonnages essayés à la fois, avant de regarder si l'un convient. */
    private static final int LOT = 8;

    /** Part de l'erreur voulue que les limites peuvent prendre sans gêner la mesure des échantillonnages. */
    private static final double PART_DES_LIMITES = 0.25;

    /** L'erreur qu'il faut savoir mesurer quand c'est un temps qui est voulu, en niveaux. */
    private static final double ERREUR_VISEE = 1;

    private final Options options;
    private final double erreurVisee;
    private final Essais essais;
    private final Semis semis;
    private final EssaiLimites limites;
    private final List<Finesse> finesses;
    private final Reseau reseau;
    private final Reglage choisi;
    private final Lancer lancer;
    private final Rapport rapport;
    private Tirage controle;
    private Temoin temoin;

    /**
     * Choisit, en essayant.
     *
     * @param prepare la scène, prête à être dessinée
     * @param options l'erreur ou le temps voulus, et ce que l'utilisateur a fixé, qui n'est pas changé
     * @param variantes celles dont les réglages sont permis
     * @throws lancer.SceneFautive si une variante propose un réglage fautif
     */
    public Auto(Lancer prepare, Options options, List<Variante> variantes) {
        long debut = System.nanoTime();
        this.options = options;
        erreurVisee = options.erreurVoulue > 0 ? options.erreurVoulue : ERREUR_VISEE;
        essais = new Essais(prepare, options.fils);
        semis = new Semis(essais.getCamera().getLargeur(), essais.getCamera().getHauteur());
        limites = new EssaiLimites(essais, semis.choix, options);
        finesses = Finesse.possibles(prepare.getScene(), variantes);
        reseau = Reseau.pour(erreurVisee);
        EssaiFinesses essai = new EssaiFinesses(essais, semis.choix, limitesCommunes(), reseau);
        EssaiTemps temps = new EssaiTemps(essais, options.fils, options.tempsVoulu);
        Reglage meilleur = options.erreurVoulue > 0 ? pourUneErreur(essai) : pourUnTemps(essai, temps);
        if (!meilleur.finesse.estSure()) {
            essai.approfondir(meilleur.finesse);
        }
        choisi = new Reglage(meilleur.finesse, meilleur.limites);
        lancer = getLancer(choisi);
        rapport = new Rapport(options, choisi, finesses.size() * limites.permises.size(), essai.pixels(),
                temps.getAttendu(), System.nanoTime() - debut);
    }

    /** Le moins cher de ceux qui tiennent l'erreur voulue ; le plus juste de tous si aucun ne la tient. */
    private Reglage pourUneErreur(EssaiFinesses essai) {
        for (int k = 0; k < finesses.size(); k += LOT) {
            essai.essayer(finesses.subList(k, Math.min(k + LOT, finesses.size())));
            Reglage semble = Choix.moinsCher(getEssayes(), options.erreurVoulue);
            while (semble != null && !semble.finesse.estSure()) {
                essai.approfondir(semble.finesse);
                semble = Choix.moinsCher(getEssayes(), options.erreurVoulue);
            }
            if (semble != null) {
                return semble;
            }
        }
        return Choix.plusJuste(getEssayes(), Double.POSITIVE_INFINITY);
    }

    private Reglage pourUnTemps(EssaiFinesses essai, EssaiTemps temps) {
        essai.essayer(finesses);
        return temps.choisir(getEssayes());
    }

    /** Les limites où s'essaient les échantillonnages : les moins chères qui n'y changent presque rien. */
    private Limites limitesCommunes() {
        Limites communes = limites.exactes;
        for (Limites l : limites.permises) {
            if (l.erreur.auPlus() <= PART_DES_LIMITES * erreurVisee && l.rayons < communes.rayons) {
                communes = l;
            }
        }
        return communes;
    }

    /** Ce qui est choisi. */
    public Reglage getChoisi() {
        return choisi;
    }

    /** De quoi dessiner la scène comme il est choisi, à la profondeur que dit {@link #getChoisi()}. */
    public Lancer getLancer() {
        return lancer;
    }

    /** De quoi la dessiner autrement. */
    public Lancer getLancer(Reglage reglage) {
        return essais.lancer(reglage.finesse.getEchantillonnage(), reglage.limites.seuil);
    }

    /** Les réglages essayés, avec ce qui en est attendu. */
    public List<Reglage> getEssayes() {
        return Choix.reglages(finesses, limites.permises);
    }

    /** Pourquoi ce choix, et ce qu'il en est. */
    public Rapport getRapport() {
        return rapport;
    }

    /** @return ce qu'il faut donner à dessiner pour que {@code toile} le soit, et que l'image puisse être contrôlée */
    public Toile surveiller(Toile toile) {
        // une image d'un seul bloc n'en a pas d'autre
        List<Bloc> blocs = semis.controle.isEmpty() ? semis.choix : semis.controle;
        controle = EssaiFinesses.tirer(essais, blocs, limites.exactes);
        temoin = new Temoin(toile, essais.getCamera().getLargeur(), controle.blocs);
        return temoin;
    }

    /** Mesure l'image dessinée, sur d'autres pixels que ceux du choix s'il y en a, et l'ajoute au rapport. */
    public void controler() {
        long debut = System.nanoTime();
        double[] ecarts = new double[controle.blocs.size()];
        essais.passer(controle.blocs, limites.exactes.reflets, 0, (rang, bloc, pave, vue) ->
                ecarts[rang] = temoin.releve(rang).ecart(Releve.references(bloc, vue, reseau)));
        rapport.controler(controle.estimer(ecarts), controle.pixels(), !semis.controle.isEmpty(), lancer.getDureeNs(),
                System.nanoTime() - debut);
    }
}
