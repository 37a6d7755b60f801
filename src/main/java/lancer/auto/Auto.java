package lancer.auto;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Lancer;
import lancer.contrat.Pave;
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

    private static final double NS_PAR_S = 1e9;
    private static final double NS_PAR_MS = 1e6;

    private final Souhait souhait;
    private final double erreurVisee;
    private final Essais essais;
    private final Semis semis;
    private final EssaiLimites limites;
    private final List<Finesse> finesses;
    private final Reseau reseau;
    private Reglage choisi;
    private double tempsAttendu;
    private int pixelsEssayes;
    private long essaisNs;
    private Lancer lancer;
    private Tirage controle;
    private Prelevement prelevement;
    private Estimation mesuree;

    private Auto(Lancer prepare, Souhait souhait, int fils, List<Variante> variantes) {
        this.souhait = souhait;
        erreurVisee = souhait.erreur > 0 ? souhait.erreur : ERREUR_VISEE;
        essais = new Essais(prepare, fils);
        semis = new Semis(essais.camera.getLargeur(), essais.camera.getHauteur());
        limites = new EssaiLimites(essais, semis.choix);
        finesses = Finesse.possibles(prepare.getScene(), variantes);
        reseau = Reseau.pour(erreurVisee);
    }

    /**
     * Choisit, en essayant.
     *
     * @param prepare la scène, prête à être dessinée
     * @param variantes celles dont les réglages sont permis
     * @throws lancer.SceneFautive si une variante propose un réglage fautif
     */
    public static Auto choisir(Lancer prepare, Souhait souhait, int fils, List<Variante> variantes) {
        long debut = System.nanoTime();
        Auto auto = new Auto(prepare, souhait, fils, variantes);
        auto.choisir();
        auto.essaisNs = System.nanoTime() - debut;
        return auto;
    }

    private void choisir() {
        limites.essayer(souhait);
        EssaiFinesses essai = EssaiFinesses.parmi(semis.choix, essais, limitesCommunes(), reseau);
        choisi = souhait.erreur > 0 ? pourUneErreur(essai) : pourUnTemps(essai);
        if (!choisi.finesse.sure) {
            essai.approfondir(choisi.finesse);
        }
        pixelsEssayes = essai.pixels();
        lancer = getLancer(choisi);
    }

    /** Le moins cher de ceux qui tiennent l'erreur voulue ; le plus juste de tous si aucun ne la tient. */
    private Reglage pourUneErreur(EssaiFinesses essai) {
        for (int k = 0; k < finesses.size(); k += LOT) {
            essai.essayer(finesses.subList(k, Math.min(k + LOT, finesses.size())));
            Reglage semble = Choix.moinsCher(getEssayes(), souhait.erreur);
            while (semble != null && !semble.finesse.sure) {
                essai.approfondir(semble.finesse);
                semble = Choix.moinsCher(getEssayes(), souhait.erreur);
            }
            if (semble != null) {
                return semble;
            }
        }
        return Choix.plusJuste(getEssayes(), Double.POSITIVE_INFINITY);
    }

    private Reglage pourUnTemps(EssaiFinesses essai) {
        EssaiTemps temps = new EssaiTemps(essais);
        essai.essayer(finesses);
        Reglage juste = temps.choisir(getEssayes(), souhait.temps);
        tempsAttendu = temps.attendu;
        return juste;
    }

    /** Les limites où s'essaient les échantillonnages : les moins chères qui n'y changent presque rien. */
    private LimitesDesReflets limitesCommunes() {
        LimitesDesReflets communes = limites.exactes;
        for (LimitesDesReflets l : limites.permises) {
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
        return essais.lancer(reglage.finesse.echantillonnage, reglage.limites.seuil);
    }

    /** Les réglages essayés, avec ce qui en est attendu. */
    public List<Reglage> getEssayes() {
        List<Reglage> reglages = new ArrayList<>();
        for (Finesse finesse : finesses) {
            if (finesse.erreur != null) {
                limites.permises.forEach(l -> reglages.add(new Reglage(finesse, l)));
            }
        }
        return reglages;
    }

    /** Vrai si ce qui est voulu devrait être tenu. */
    public boolean estTenable() {
        return souhait.estTenu(choisi.getErreurAuPlus(), tempsAttendu);
    }

    /** @return ce qu'il faut donner à dessiner pour que {@code toile} le soit, et que l'image puisse être contrôlée */
    public Toile surveiller(Toile toile) {
        // une image d'un seul bloc n'en a pas d'autre
        List<Pave> blocs = semis.controle.isEmpty() ? semis.choix : semis.controle;
        controle = EssaiFinesses.tirer(essais, blocs, limites.exactes);
        prelevement = new Prelevement(toile, essais.camera.getLargeur(), controle.blocs);
        return prelevement;
    }

    /** Mesure l'image dessinée, sur d'autres pixels que ceux du choix s'il y en a. */
    public void controler() {
        long debut = System.nanoTime();
        double[] ecarts = new double[controle.blocs.size()];
        essais.passer(controle.blocs, limites.exactes.reflets, 0, (rang, bloc, pave, vue) ->
                ecarts[rang] = prelevement.de(bloc).ecart(Niveaux.references(bloc, vue, reseau)));
        mesuree = controle.estimer(ecarts);
        essaisNs += System.nanoTime() - debut;
    }

    /** L'erreur de l'image, mesurée par {@link #controler}, en niveaux. */
    public double getErreurMesuree() {
        return mesuree.erreur();
    }

    /** Trois lignes : le choix, pourquoi, et ce qu'il en est. */
    public List<String> getLignes() {
        String pixels = CompteRendu.pixels(controle.pixels(), !semis.controle.isEmpty(), pixelsEssayes);
        int possibles = finesses.size() * limites.permises.size();
        return Arrays.asList("auto, choisi : " + choisi,
                "auto, attendu : " + CompteRendu.attente(souhait, choisi, possibles, tempsAttendu),
                "auto, mesuré : " + CompteRendu.controle(souhait, mesuree, pixels, lancer.getDureeNs() / NS_PAR_S,
                        essaisNs / NS_PAR_S));
    }

    /** Des lignes de plus pour {@code --statistiques}. */
    public String getStatistiques() {
        return CompteRendu.texte("auto.erreur.attendue: %.2f%nauto.erreur.mesuree: %.2f%nauto.essais.ms: %.3f",
                choisi.getErreur(), mesuree.erreur(), essaisNs / NS_PAR_MS);
    }
}
