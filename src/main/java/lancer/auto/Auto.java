package lancer.auto;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntFunction;
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
    /** Part des rayons de l'image dessinée que peut demander son contrôle. */
    private static final double PART = 0.6;
    /** Quantile à 95 % de la loi normale : un verdict est faux au plus une fois sur vingt. */
    private static final double SUR = 1.64;

    private final Lancer prepare;
    private final List<Reglages> echelle;
    private final double voulue;
    private final int fils;
    private final SplittableRandom hasard;
    private int rang;
    private boolean repris;
    private Lancer lancer;
    private Echantillon echantillon;
    private Mesure mesure;
    private String conseil = "";
    private long rayons;

    /** @param prepare la scène, préparée @param echelle un réglage au moins @param voulue l'erreur, en niveaux */
    public Auto(Lancer prepare, List<Reglages> echelle, double voulue, int fils) {
        this.prepare = prepare;
        this.echelle = echelle;
        this.voulue = voulue;
        this.fils = fils;
        // deux demandes ne regardent pas les mêmes pixels
        hasard = new SplittableRandom(Double.doubleToLongBits(voulue));
        echantillon = new Echantillon(prepare, fils, null, voulue,
                prepare.getCamera().getLargeur() * prepare.getCamera().getHauteur(), hasard);
        choisir();
    }

    /** Monte jusqu'au premier échelon qui convient à cet échantillon, ou que le suivant n'améliore pas assez. */
    private void choisir() {
        Mesure ici = echantillon.essayer(getChoisi());
        while (PRUDENCE * ici.erreur > voulue && rang < echelle.size() - 1) {
            Mesure suivante = echantillon.essayer(echelle.get(rang + 1));
            // ce qui reste n'est peut-être que le hasard des références : seule leur différence en est libre
            if (ici.plus(-SUR) == 0 && ici.gain(suivante, SUR) < voulue * voulue / 4) {
                break;
            }
            rang++;
            ici = suivante;
        }
        rayons += echantillon.rayons;
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
        echantillon = new Echantillon(prepare, fils, dessinee, voulue,
                (long) (PART * lancer.getCompteurs().rayons()), hasard);
        mesure = echantillon.mesurer();
        boolean depassee = mesure.plus(-SUR) > voulue;
        if (depassee && rang < echelle.size() - 1 && !repris) {
            repris = true;
            rang++;
            rayons += lancer.getCompteurs().rayons();
            choisir();
            return false;
        }
        conseil = mesure.plus(SUR) <= voulue ? "" : conseiller();
        rayons += echantillon.rayons;
        return true;
    }

    /** Ce qui, sur les pixels du contrôle, diminue l'erreur ; rien, si rien ne le fait. */
    private String conseiller() {
        if (rang < echelle.size() - 1) {
            return mesure.gain(echantillon.essayer(echelle.get(rang + 1)), -SUR) <= 0 ? ""
                    : " : demander deux fois moins d'erreur aiderait";
        }
        // toutes les réflexions sont suivies : ce qui reste est le crénelage
        return lancer.getScene().getModele().getEchantillonnage() != null
                || getChoisi().getProfondeur() < Echelle.PROFONDEUR ? ""
                : " : il faudrait l'anticrénelage, celui d'antialias/target/antialias.jar";
    }

    public Mesure getMesure() {
        return mesure;
    }

    /** Nombre de rayons de toutes sortes des essais, des contrôles et des images remplacées. */
    public long getRayonsDesEssais() {
        return rayons;
    }

    /** L'erreur voulue est tenue, dépassée ou incertaine, et un conseil ; vide là où rien n'est vu. */
    public String getVerdict() {
        if (mesure.rienVu) {
            return "";
        }
        if (mesure.plus(SUR) <= voulue) {
            return "erreur voulue tenue";
        }
        return "erreur voulue " + (mesure.plus(-SUR) > voulue ? "dépassée" : "incertaine") + conseil;
    }
}
