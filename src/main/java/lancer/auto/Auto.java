package lancer.auto;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import lancer.Couleur;
import lancer.Lancer;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Variante;

/**
 * {@code --auto} : choisit comment dessiner une scène, d'après quelques pixels essayés de plusieurs façons, et contrôle
 * ensuite l'image sur d'autres. L'erreur est celle d'{@link Estimation}, contre la moyenne du pixel sans limite de
 * réflexions ; le prix se compte en rayons. Du réglage le moins cher, on va vers les plus justes, toujours par le même
 * chemin, jusqu'à ce qui est voulu : vouloir moins d'erreur ne peut donc en annoncer plus. Pour une erreur voulue, le
 * choix ne dépend que de la scène, de la taille et de ce qui est voulu ou fixé ; pour un temps voulu, il dépend aussi
 * de la machine. Le brouillon n'est jamais choisi : ce n'est pas une image.
 */
public final class Auto {

    /** Blocs où s'essaient les limites et se cherche le contraste. */
    private static final int BLOCS_MIN = 200;
    private static final int BLOCS_MAX = 4000;

    /** Part des rayons du choix qui va à ces blocs, et ce que chacun y demande de points. */
    private static final double PART_DES_BLOCS = 0.3;
    private static final int POINTS_PAR_BLOC = EssaiFinesses.POINTS + 6;

    /** Part de ce qui reste que prennent les blocs tirés pour mesurer une erreur ; une moindre en tirera d'autres. */
    private static final double PART_DES_TIRAGES = 0.7;

    /** L'erreur que les limites peuvent faire sans gêner la mesure des échantillonnages, en niveaux. */
    private static final double GENE = 0.25;

    private static final double NS_PAR_S = 1e9;
    private static final double MS_PAR_S = 1e3;

    private final Souhait souhait;
    private final Essais essais;
    private final Budget budget;
    private final List<Finesse> finesses;
    private final Consumer<Auto> suivi;
    private EssaiLimites limites;
    private EssaiFinesses essai;

    /** De moins en moins d'erreur, attendue comme au plus. */
    private final List<Reglage> front = new ArrayList<>();
    private final List<Reglage> essayes = new ArrayList<>();
    private int semes;
    private int finessesVues;
    private Reglage choisi;
    private double tempsAttendu;
    private double essaisS;
    private Lancer lancer;
    private EssaiFinesses controle;
    private Prelevement prelevement;
    private Estimation mesuree;

    private Auto(Lancer prepare, Souhait souhait, int fils, List<Variante> variantes, Consumer<Auto> suivi) {
        this.souhait = souhait;
        this.suivi = suivi;
        essais = new Essais(prepare, fils);
        budget = new Budget(souhait, essais);
        finesses = Finesse.possibles(prepare.getScene(), variantes);
    }

    /**
     * Choisit, en essayant.
     *
     * @param prepare la scène, prête à être dessinée
     * @param variantes celles dont les réglages sont permis
     * @throws lancer.SceneFautive si une variante propose un réglage fautif
     */
    public static Auto choisir(Lancer prepare, Souhait souhait, int fils, List<Variante> variantes) {
        return choisir(prepare, souhait, fils, variantes, auto -> { });
    }

    /**
     * Choisit, en disant où il en est.
     *
     * @param suivi appelé dans ce fil après chaque pas
     * @throws java.util.concurrent.CancellationException si ce fil est interrompu
     */
    public static Auto choisir(Lancer prepare, Souhait souhait, int fils, List<Variante> variantes,
            Consumer<Auto> suivi) {
        Auto auto = new Auto(prepare, souhait, fils, variantes, suivi);
        auto.semer();
        auto.monter();
        auto.choisir();
        auto.essaisS = auto.budget.ecoule();
        return auto;
    }

    /** Sème autant de blocs que le plus petit dessin le permet, et y essaie ce qui ne dépend pas d'une finesse. */
    private void semer() {
        List<Pave> blocs = essais.semer(BLOCS_MIN, false);
        limites = new EssaiLimites(essais, blocs, souhait);
        double prix = limites.exactes.rayons;
        double permis = PART_DES_BLOCS * budget.pourChoisir(prix) / (POINTS_PAR_BLOC * prix);
        if (permis > BLOCS_MIN) {
            blocs = essais.semer((int) Math.min(BLOCS_MAX, permis), false);
            limites = new EssaiLimites(essais, blocs, souhait);
        }
        LimitesDesReflets communes = limites.permises.stream().filter(l -> l.erreur.auPlus() <= GENE).findFirst()
                .orElse(limites.exactes);
        semes = blocs.size();
        essai = new EssaiFinesses(essais, blocs, communes);
        affiner(Double.POSITIVE_INFINITY, limites.permises.get(0).rayons);
    }

    /** Du moins cher au plus juste : à chaque pas, ce qui retire le plus d'erreur par rayon de plus. */
    private void monter() {
        Iterator<Finesse> suivantes = finesses.iterator();
        int profondeur = 0;
        Finesse suivante = null;
        Finesse finesse = essayer(suivantes.next());
        while (true) {
            Reglage ici = noter(approfondir(finesse, profondeur), profondeur);
            if (front.isEmpty() || ici.estPlusJusteQue(front.get(front.size() - 1))) {
                front.add(ici);
            }
            suivi.accept(this);
            if (suffit(front.get(front.size() - 1))) {
                return;
            }
            while (suivantes.hasNext() && (suivante == null || suivante.erreur.carre() >= finesse.erreur.carre())) {
                suivante = essayer(suivantes.next());
            }
            boolean plusFin = suivante != null && suivante.erreur.carre() < finesse.erreur.carre();
            boolean plusLoin = profondeur + 1 < limites.permises.size();
            if (plusFin && plusLoin) {
                plusLoin = noter(finesse, profondeur + 1).gain(ici) > noter(suivante, profondeur).gain(ici);
            }
            if (plusLoin) {
                profondeur++;
            } else if (plusFin) {
                finesse = suivante;
            } else {
                return;
            }
        }
    }

    private Finesse essayer(Finesse finesse) {
        essai.essayer(finesse);
        finessesVues++;
        return finesse;
    }

    /** La même, contre des références aussi fines que son erreur le demande. */
    private Finesse approfondir(Finesse finesse, int profondeur) {
        double prix = finesse.prix * essai.rayonsParRayon(limites.permises.get(profondeur));
        while (affiner(finesse.erreur.erreur(), prix)) {
            essai.essayer(finesse);
        }
        return finesse;
    }

    private boolean affiner(double erreur, double prix) {
        return essai.affiner(erreur, PART_DES_TIRAGES * budget.pourChoisir(prix));
    }

    private Reglage noter(Finesse finesse, int profondeur) {
        LimitesDesReflets l = limites.permises.get(profondeur);
        Reglage reglage = new Reglage(finesse, l, essai.rayonsParRayon(l));
        essayes.add(reglage);
        return reglage;
    }

    private boolean suffit(Reglage reglage) {
        return souhait.temps > 0 ? budget.pourChoisir(0) <= essai.prochain() || !tient(reglage)
                : reglage.getErreurAuPlus() <= souhait.erreur;
    }

    private boolean tient(Reglage reglage) {
        return budget.ecoule() + budget.dessin(reglage.getPrix()) <= souhait.temps;
    }

    /** Pour une erreur, le premier qui la tient, ou le plus juste ; pour un temps, le plus juste qui le tient. */
    private void choisir() {
        int k = front.size() - 1;
        while (souhait.temps > 0 && k > 0 && !tient(front.get(k))) {
            k--;
        }
        choisi = front.get(k);
        essai.chiffrer(choisi.finesse, choisi.limites, PART_DES_TIRAGES * budget.pourControler(choisi.getPrix()));
        tempsAttendu = souhait.temps > 0 ? budget.ecoule() + budget.dessin(choisi.getPrix()) : 0;
        lancer = getLancer(choisi);
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
        return essayes;
    }

    /** Ceux que rien d'essayé ne domine, du moins cher au plus juste. */
    public List<Reglage> getFront() {
        return front;
    }

    /** Échantillonnages qui restent à essayer, au plus. */
    public int getRestants() {
        return finesses.size() - finessesVues;
    }

    /** Secondes que demande un rayon de plus, d'après les essais. */
    public double getSecondesParRayon() {
        return essais.parRayon();
    }

    /** Les rayons des essais, contrôle compris. */
    public long getRayonsDesEssais() {
        return essais.rayons();
    }

    /** Vrai si ce qui est voulu devrait être tenu. */
    public boolean estTenable() {
        return souhait.estTenu(choisi.getErreurAuPlus(), tempsAttendu);
    }

    /** Ce qui est attendu de la scène telle qu'elle est, sous ces limites ; à demander une fois choisi. */
    public Reglage evaluer(int reflets, double seuil) {
        LimitesDesReflets l = limites.essayer(reflets, seuil);
        return new Reglage(essayer(Finesse.de(essais.scene())), l, essai.rayonsParRayon(l));
    }

    /** Mesure une image dessinée avec ce réglage. @return son erreur, et son incertitude, en niveaux */
    public double[] mesurer(Reglage reglage, BiFunction<Integer, Integer, Couleur> image) {
        preparerLeControle((couleur, xe, ye) -> { }, reglage, Double.POSITIVE_INFINITY);
        for (Pave bloc : controle.tirage().blocs) {
            for (int k = 0; k < bloc.pixels(); k++) {
                int i = bloc.i0 + k % (bloc.i1 - bloc.i0);
                int j = bloc.j0 + k / (bloc.i1 - bloc.i0);
                prelevement.drawPixel(image.apply(i, j), i, j);
            }
        }
        controler();
        return new double[] {mesuree.erreur(), mesuree.incertitude()};
    }

    /** @return ce qu'il faut donner à dessiner pour que {@code toile} le soit, et que l'image puisse être contrôlée */
    public Toile surveiller(Toile toile) {
        preparerLeControle(toile, choisi, budget.pourControler(choisi.getPrix()));
        return prelevement;
    }

    private void preparerLeControle(Toile toile, Reglage reglage, double rayons) {
        double debut = budget.ecoule();
        List<Pave> blocs = essais.semer(semes, true);
        // une image d'un seul bloc n'en a pas d'autre
        controle = new EssaiFinesses(essais, blocs.isEmpty() ? essais.semer(1, false) : blocs, limites.exactes);
        controle.affiner(reglage.getErreur(), rayons);
        prelevement = new Prelevement(toile, essais.camera.getLargeur(), controle.tirage().blocs);
        essaisS += budget.ecoule() - debut;
    }

    /** Mesure l'image dessinée, sur d'autres pixels que ceux du choix s'il y en a. */
    public void controler() {
        double debut = budget.ecoule();
        mesuree = controle.mesurer(prelevement);
        essaisS += budget.ecoule() - debut;
    }

    /** L'erreur de l'image, mesurée par {@link #controler}, en niveaux. */
    public double getErreurMesuree() {
        return mesuree.erreur();
    }

    /** Trois lignes : le choix, pourquoi, et ce qu'il en est. */
    public List<String> getLignes() {
        return Arrays.asList("auto, choisi : " + choisi,
                "auto, attendu : " + CompteRendu.attente(souhait, choisi, essayes.size(), tempsAttendu),
                "auto, mesuré : " + CompteRendu.controle(souhait, mesuree, controle.tirage().pixels(),
                        lancer.getDureeNs() / NS_PAR_S, essaisS));
    }

    /** Des lignes de plus pour {@code --statistiques}. */
    public String getStatistiques() {
        return CompteRendu.texte("auto.erreur.attendue: %.2f%nauto.erreur.mesuree: %.2f%nauto.essais.rayons: %d%n"
                + "auto.essais.ms: %.3f", choisi.getErreur(), mesuree.erreur(), essais.rayons(), essaisS * MS_PAR_S);
    }
}
