package lancer.auto;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntFunction;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lancer;
import lancer.commande.Reglages;

/**
 * {@code --auto} : essaie des réglages sur quelques pixels, du moins cher au plus juste, et choisit le premier qui
 * convient. L'erreur de l'image dessinée est mesurée sur d'autres pixels. Si elle dépasse l'erreur voulue, un échelon
 * plus juste est choisi. Le choix ne dépend que de la scène, de la taille et de l'erreur voulue.
 */
public final class Auto {

    /** Facteur de prudence sur l'erreur d'un essai. */
    private static final double PRUDENCE = 1.2;
    /** Ce par quoi un échelon divise à peu près l'erreur du précédent, là où l'essai n'en voit pas. */
    private static final double GAIN = 1.4;
    /** Quantile à 95 % de la loi normale : un verdict est faux au plus une fois sur vingt. */
    private static final double SUR = 1.64;

    /** Nombre de pavés d'un essai. */
    private static final int PAVES = 8;

    private final Lancer prepare;
    private final List<Reglages> echelle;
    private final double voulue;
    private final int fils;
    private final SplittableRandom hasard;
    private final Echantillon essai;
    /** L'échelon choisi, et son erreur sur les pixels de l'essai. */
    private int rang;
    private Mesure essaye;
    private Lancer lancer;
    private Mesure mesure;
    private long rayons;

    /** @param prepare la scène, préparée @param echelle un réglage au moins @param voulue l'erreur, en niveaux */
    public Auto(Lancer prepare, List<Reglages> echelle, double voulue, int fils) {
        this.prepare = prepare;
        this.echelle = echelle;
        this.voulue = voulue;
        this.fils = fils;
        // deux demandes ne regardent pas les mêmes pixels
        hasard = new SplittableRandom(Double.doubleToLongBits(voulue));
        int pixels = prepare.getCamera().getLargeur() * prepare.getCamera().getHauteur();
        essai = new Echantillon(prepare, fils, k -> Constantes.CIEL, voulue, pixels, PAVES, hasard);
        essaye = essai.essayer(getChoisi());
        while (PRUDENCE * essaye.erreur > voulue && rang < echelle.size() - 1) {
            Mesure suivante = essai.essayer(echelle.get(rang + 1));
            // ce qui reste n'est peut-être que le hasard des références : seule leur différence en est libre
            if (essaye.plus(-SUR) == 0 && essaye.moins(suivante).plus(SUR) < voulue / 2) {
                break;
            }
            rang++;
            essaye = suivante;
        }
        lancer = prepare.avec(getChoisi().getModele());
    }

    public Reglages getChoisi() {
        return echelle.get(rang);
    }

    /** Le lancer qui dessine la scène avec l'échelon choisi. */
    public Lancer getLancer() {
        return lancer;
    }

    /**
     * Mesure l'erreur de l'image dessinée.
     *
     * @param dessinee la couleur de chacun de ses pixels, par son rang, ligne par ligne
     * @return faux s'il faut dessiner, une fois, l'échelon désormais choisi
     */
    public boolean controler(IntFunction<Couleur> dessinee) {
        boolean premiere = mesure == null;
        Echantillon controle = new Echantillon(prepare, fils, dessinee, voulue,
                lancer.getAtelier().getCompteurs().primaires, Integer.MAX_VALUE, hasard);
        mesure = controle.mesurer(dessinee);
        rayons += controle.rayons;
        if (premiere && mesure.erreur > voulue && rang < echelle.size() - 1) {
            rayons += lancer.getAtelier().getCompteurs().rayons();
            monter(voulue / (PRUDENCE * mesure.erreur));
            lancer = prepare.avec(getChoisi().getModele());
            return false;
        }
        return true;
    }

    /** Choisit le premier échelon plus cher qui ne laisse au plus que cette part de l'erreur, d'après l'essai. */
    private void monter(double part) {
        double reste = 1;
        while (reste > part && rang < echelle.size() - 1) {
            rang++;
            reste = essaye.aUnIntervalle ? essai.essayer(getChoisi()).erreur / essaye.erreur : reste / GAIN;
        }
    }

    public Mesure getMesure() {
        return mesure;
    }

    /** Nombre de rayons de toutes sortes des essais, des contrôles et des images remplacées. */
    public long getRayonsDesEssais() {
        return rayons + essai.rayons;
    }

    /** L'erreur voulue est tenue, dépassée ou incertaine : ce qui se dit d'une erreur qui a été vue. */
    public String getVerdict() {
        String autrement = mesure.plus(-SUR) > voulue ? "dépassée" : "incertaine";
        return "erreur voulue " + (mesure.plus(SUR) <= voulue ? "tenue" : autrement);
    }
}
