package lancer.auto;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Variante;
import lancer.fils.Traceur;

/**
 * {@code --auto} : choisit comment dessiner une scène, d'après quelques pixels essayés de plusieurs façons, et contrôle
 * ensuite l'image sur d'autres. Le prix se compte en rayons. Du réglage le moins cher, on va vers les plus justes,
 * toujours par le même chemin, jusqu'à ce qui est voulu : vouloir moins d'erreur ne peut donc en annoncer plus. Pour
 * une erreur voulue, le choix ne dépend que de la scène, de la taille et de ce qui est voulu ou fixé ; pour un temps
 * voulu, il dépend aussi de la machine. Le brouillon n'est jamais choisi : ce n'est pas une image.
 */
public final class Auto {

    /** Rayons permis aux essais d'un petit dessin : à peu près 0,2 s d'une machine virtuelle qui démarre. */
    private static final double PLANCHER = 530_000;

    /** Part que coûtent ceux d'un autre, de ses rayons au-delà des premiers, que la compilation fait attendre. */
    private static final double PART = 0.33;
    private static final double DEMARRAGE = 700_000;

    /** Parts des essais qui vont à semer, à tirer, à tout le chemin, jusqu'au prix du choix ; le reste au contrôle. */
    private static final double PART_DES_BLOCS = 0.2;
    private static final double PART_DES_TIRAGES = 0.35;
    private static final double PART_DU_CHEMIN = 0.78;
    private static final double PART_DU_CHOIX = 0.88;

    /** Combien de fois le prix du plus juste trouvé peut coûter le suivant : essayé, c'est lui qui sera choisi. */
    private static final double RENCHERI = 2.5;

    /** Le temps d'un dessin, rapporté à celui de ses rayons dans le meilleur essai : une machine n'est jamais seule. */
    private static final double PRUDENCE = 1.2;

    /** Secondes que prend le dessin d'un programme qui démarre ; de celles qui restent, ce qui va à le chronométrer. */
    private static final double DEMARRAGE_S = 0.4;
    private static final double PART_DU_CHRONOMETRE = 0.25;
    private static final double CHRONOMETRE_S = 0.2;

    private final Souhait souhait;
    private final Essais essais;
    private final double pixels;
    private final Deque<Finesse> finesses;
    private final long debut = System.nanoTime();
    private EssaiLimites limites;
    private EssaiFinesses essai;

    /** De moins en moins d'erreur, attendue comme au plus. */
    private final List<Reglage> front = new ArrayList<>();
    private final List<Reglage> essayes = new ArrayList<>();
    private Reglage choisi;
    private double tempsAttendu;
    private double essaisS;
    private Traceur lancer;
    private Reglage surveille;
    private Controle controle;
    private Estimation mesuree;

    private Auto(Traceur prepare, Souhait souhait, int fils, List<Variante> variantes) {
        this.souhait = souhait;
        essais = new Essais(prepare, fils);
        pixels = (double) essais.camera.getLargeur() * essais.camera.getHauteur();
        finesses = new ArrayDeque<>(Finesse.possibles(prepare.getScene(), variantes));
    }

    /**
     * Choisit, en essayant.
     *
     * @param prepare la scène, prête à être dessinée
     * @param variantes celles dont les réglages sont permis
     * @param suivi appelé dans ce fil après chaque pas
     * @throws lancer.SceneFautive si une variante propose un réglage fautif
     * @throws java.util.concurrent.CancellationException si ce fil est interrompu
     */
    public static Auto choisir(Traceur prepare, Souhait souhait, int fils, List<Variante> variantes,
            Consumer<Auto> suivi) {
        Auto auto = new Auto(prepare, souhait, fils, variantes);
        auto.monter(suivi);
        auto.choisir();
        auto.essaisS = auto.ecoule();
        return auto;
    }

    private double ecoule() {
        return (System.nanoTime() - debut) / Essais.NS_PAR_S;
    }

    /** Le temps qu'il faudrait pour dessiner à ce prix par pixel, en secondes. */
    private double dessin(double prix) {
        return PRUDENCE * prix * pixels * essais.parRayon;
    }

    /** Les rayons permis aux essais, si le dessin est à ce prix par pixel ; d'un temps voulu, ceux de sa moitié. */
    private double permis(double prix) {
        return souhait.temps > 0
                ? Math.max(0, Math.min(souhait.temps / 2, souhait.temps - dessin(prix))) / essais.parRayon
                : Math.max(PLANCHER, PART * (prix * pixels - DEMARRAGE));
    }

    private double depense() {
        return souhait.temps > 0 ? ecoule() / essais.parRayon : essais.rayons();
    }

    /** Du moins cher au plus juste : à chaque pas, la plus grande des deux parts de l'erreur diminue. */
    private void monter(Consumer<Auto> suivi) {
        if (souhait.temps > DEMARRAGE_S) {
            essais.chronometrer(Math.min(CHRONOMETRE_S, PART_DU_CHRONOMETRE * (souhait.temps - DEMARRAGE_S)));
        }
        limites = new EssaiLimites(essais, souhait, () -> PART_DES_BLOCS * permis(1));
        essai = new EssaiFinesses(essais, limites.blocs, limites.exactes, PART_DES_TIRAGES * permis(1));
        int profondeur = 0;
        Finesse suivante = finesses.remove();
        essai.essayer(suivante, Double.POSITIVE_INFINITY,
                finesse -> (PART_DES_BLOCS + PART_DES_TIRAGES) * permis(1) - depense());
        Reglage ici = noter(suivante, profondeur);
        while (true) {
            Reglage mieux = front.isEmpty() ? null : front.get(front.size() - 1);
            if (mieux == null || ici.erreur < mieux.erreur && ici.erreurAuPlus < mieux.erreurAuPlus) {
                mieux = ici;
                front.add(mieux);
            }
            suivi.accept(this);
            if (suffit(mieux)) {
                return;
            }
            boolean plusLoin = profondeur + 1 < limites.permises.size();
            boolean aReflets = ici.limites.erreur.carre > ici.finesse.erreur.carre;
            if (plusLoin && (aReflets || finesses.isEmpty())) {
                profondeur++;
                ici = noter(ici.finesse, profondeur);
            } else if (!finesses.isEmpty()) {
                suivante = finesses.remove();
                double prix = mieux.prix;
                double profonds = ici.limites.rayons;
                if (essai.essayer(suivante, reste(souhait.temps > 0 ? prix : RENCHERI * prix),
                        finesse -> reste(Math.max(prix, finesse.prix * profonds)))) {
                    Reglage autre = noter(suivante, profondeur);
                    ici = autre.erreur < ici.erreur ? autre : ici;
                } else {
                    finesses.clear();
                }
            } else {
                return;
            }
        }
    }

    /** Ce qui reste au chemin, si le choix est à ce prix par pixel. */
    private double reste(double prix) {
        return PART_DU_CHEMIN * permis(prix) - depense();
    }

    private Reglage noter(Finesse finesse, int profondeur) {
        Reglage reglage = new Reglage(finesse, limites.permises.get(profondeur));
        essayes.add(reglage);
        return reglage;
    }

    private boolean suffit(Reglage reglage) {
        return souhait.temps > 0 ? fin(reglage) > souhait.temps : reglage.erreurAuPlus <= souhait.erreur;
    }

    /** Quand l'image sera dessinée ainsi, et contrôlée, pour un temps voulu. */
    private double fin(Reglage reglage) {
        return ecoule() + dessin(reglage.prix) + (1 - PART_DU_CHOIX) * permis(reglage.prix) * essais.parRayon;
    }

    /** Pour une erreur, le premier qui la tient, ou le plus juste ; pour un temps, le plus juste qui le tient. */
    private void choisir() {
        int k = front.size();
        do {
            k--;
            choisi = front.get(k);
            double reste = PART_DU_CHOIX * permis(choisi.prix) - depense();
            // mieux connaître un prix ne doit pas prendre tout le temps qui le fait tenir
            essai.chiffrer(choisi.finesse, choisi.limites, souhait.temps > 0 ? reste / 2 : reste);
            choisi = new Reglage(choisi.finesse, choisi.limites);
            tempsAttendu = fin(choisi);
        } while (souhait.temps > 0 && k > 0 && tempsAttendu > souhait.temps);
        lancer = essais.prepare.avec(choisi.finesse.echantillonnage, choisi.seuil);
    }

    /** Ce qui est choisi. */
    public Reglage getChoisi() {
        return choisi;
    }

    /** De quoi dessiner la scène comme il est choisi, à la profondeur que dit {@link #getChoisi()}. */
    public Traceur getTraceur() {
        return lancer;
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
        return finesses.size();
    }

    /** Secondes que demande un rayon de plus, d'après les essais. */
    public double getSecondesParRayon() {
        return essais.parRayon;
    }

    /** Les rayons des essais, contrôle compris. */
    public long getRayonsDesEssais() {
        return essais.rayons();
    }

    /** Vrai si ce qui est voulu devrait être tenu. */
    public boolean estTenable() {
        return souhait.temps > 0 ? tempsAttendu <= souhait.temps : choisi.erreurAuPlus <= souhait.erreur;
    }

    /** Ce qui est attendu de la scène telle qu'elle est, sous ces limites ; à demander une fois choisi. */
    public Reglage evaluer(int reflets, double seuil) {
        Finesse presente = Finesse.de(essais.prepare.getScene());
        essai.essayer(presente, Double.POSITIVE_INFINITY, finesse -> Double.POSITIVE_INFINITY);
        return new Reglage(presente, limites.essayer(reflets, seuil));
    }

    /**
     * De quoi contrôler une image, sur d'autres pixels que ceux du choix s'il y en a.
     *
     * @param reglage celui de l'image
     * @return ce qu'il faut donner à dessiner pour que {@code toile} le soit
     */
    public Toile surveiller(Toile toile, Reglage reglage) {
        surveille = reglage;
        controle = new Controle(toile, essais, essais.semer(essai.blocs.size(), true));
        return controle;
    }

    /** Mesure l'image dessinée. */
    public void controler() {
        double avant = ecoule();
        double permis = permis(lancer.getCompteurs().rayons() / pixels);
        // une image qui n'est pas celle du choix se mesure sans compter
        mesuree = controle.mesurer(limites.exactes, surveille.erreur, surveille != choisi ? Double.POSITIVE_INFINITY
                : Math.max((1 - PART_DU_CHOIX) * permis, souhait.temps > 0 ? 0 : permis - depense()));
        essaisS += ecoule() - avant;
    }

    /** L'erreur de l'image, mesurée par {@link #controler}, en niveaux. */
    public double getErreurMesuree() {
        return mesuree.erreur();
    }

    /** Ce dont elle peut s'écarter, en niveaux, dix-neuf fois sur vingt. */
    public double getIncertitude() {
        return mesuree.incertitude();
    }

    /** Trois lignes : le choix, pourquoi, et ce qu'il en est. */
    public List<String> getLignes() {
        double dessin = lancer.getDureeNs() / Essais.NS_PAR_S;
        String duree = souhait.temps > 0
                ? Souhait.texte(" ; %.3f s à la vitesse des essais, eux compris", tempsAttendu) : "";
        return Arrays.asList("auto, choisi : " + choisi,
                Souhait.texte("auto, attendu : erreur d'au plus %.2f, sans doute %.2f ; %.2f rayons de l'écran par "
                        + "pixel, %.2f avec les ombres et les reflets%s ; %s", choisi.erreurAuPlus, choisi.erreur,
                        choisi.rayons, choisi.prix, duree, souhait.raison(estTenable(), essayes.size())),
                Souhait.texte("auto, mesuré : erreur de %.2f ± %.2f, sur %d pixel%s ; dessin en %.3f s, "
                        + "essais en %.3f s ; %s", mesuree.erreur(), mesuree.incertitude(), controle.pixels(),
                        controle.pixels() > 1 ? "s" : "", dessin, essaisS,
                        souhait.verdict(mesuree, dessin + essaisS)));
    }

    /** Des lignes de plus pour {@code --statistiques}. */
    public String getStatistiques() {
        return Souhait.texte("auto.erreur.attendue: %.2f%nauto.erreur.mesuree: %.2f%nauto.essais.rayons: %d%n"
                + "auto.essais.ms: %.3f", choisi.erreur, mesuree.erreur(), essais.rayons(), 1e3 * essaisS);
    }
}
