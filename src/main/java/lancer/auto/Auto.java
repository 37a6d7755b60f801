package lancer.auto;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import lancer.Lancer;
import lancer.commande.Reglages;
import lancer.contrat.Toile;

/**
 * {@code --auto} : essaie des réglages sur quelques pixels, du moins cher au plus juste, et choisit le premier qui
 * convient. L'erreur de l'image dessinée est mesurée sur d'autres pixels. Si elle dépasse l'erreur voulue, l'échelon
 * suivant est choisi. Le choix ne dépend que de la scène, de la taille et de l'erreur voulue.
 */
public final class Auto {

    /** Facteur de prudence sur l'erreur d'un essai, et nombre maximal d'images refaites. */
    private static final double PRUDENCE = 1.2;
    private static final int REPRISES = 2;

    private final Lancer prepare;
    private final List<Reglages> echelle;
    private final double voulue;
    private final int fils;
    private final SplittableRandom hasard = new SplittableRandom(1);
    private final BitSet tires = new BitSet();
    private int rang;
    private final int dernier;
    private Lancer lancer;
    private Echantillon controle;
    private Mesure mesure;
    private long rayons;

    /** @param prepare la scène, préparée @param echelle un réglage au moins @param voulue l'erreur, en niveaux */
    public Auto(Lancer prepare, List<Reglages> echelle, double voulue, int fils) {
        this.prepare = prepare;
        this.echelle = echelle;
        this.voulue = voulue;
        this.fils = fils;
        Echantillon essai = tirer(1);
        while (rang < echelle.size() - 1 && PRUDENCE * essai.essayer(getChoisi()).erreur > voulue) {
            rang++;
        }
        dernier = Math.min(rang + REPRISES, echelle.size() - 1);
        rayons = essai.rayons;
        lancer = prepare.avec(getChoisi().getModele());
    }

    private Echantillon tirer(int essais) {
        int cote = (int) Math.max(3, Math.min(12, Math.rint(4 / Math.cbrt(voulue))));
        return new Echantillon(prepare, fils, essais, cote, hasard, tires);
    }

    public Reglages getChoisi() {
        return echelle.get(rang);
    }

    /** Le lancer qui dessine la scène avec l'échelon choisi. */
    public Lancer getLancer() {
        return lancer;
    }

    /** Toile qui dessine sur {@code toile}, et retient de nouveaux pixels pour {@link #controler()}. */
    public Toile surveiller(Toile toile) {
        controle = tirer(2);
        return (couleur, xe, ye) -> {
            toile.drawPixel(couleur, xe, ye);
            controle.drawPixel(couleur, xe, ye);
        };
    }

    /** Mesure l'erreur de l'image dessinée. @return faux s'il faut dessiner l'échelon suivant, désormais choisi */
    public boolean controler() {
        mesure = controle.mesurer();
        rayons += controle.rayons;
        boolean fini = mesure.plus(-1) <= voulue || rang == dernier;
        if (!fini) {
            rang++;
            rayons += lancer.getCompteurs().rayons();
            lancer = prepare.avec(getChoisi().getModele());
        }
        return fini;
    }

    public Mesure getMesure() {
        return mesure;
    }

    /** Nombre de rayons de toutes sortes des essais, des contrôles et des images remplacées. */
    public long getRayonsDesEssais() {
        return rayons;
    }

    /** Verdict à un écart type près : l'erreur voulue est tenue, dépassée ou incertaine. Un conseil suit. */
    public String getVerdict() {
        return mesure.plus(1) <= voulue ? "erreur voulue tenue"
                : "erreur voulue " + (mesure.plus(-1) > voulue ? "dépassée : " : "incertaine : ")
                + (rang < echelle.size() - 1 ? "demander deux fois moins d'erreur aiderait"
                : lancer.getScene().getModele().getEchantillonnage() == null
                ? "il faudrait l'anticrénelage, celui d'antialias/target/antialias.jar"
                : "il faudrait une grille plus fine, n=64 et seuil=0 au plus");
    }
}
