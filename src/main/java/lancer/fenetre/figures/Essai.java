package lancer.fenetre.figures;

import java.util.Arrays;
import java.util.Locale;
import lancer.commande.Reglages;
import lancer.contrat.Section;

/** Un réglage, l'erreur de son image, et les temps de ses dessins. Immuable. */
public final class Essai {

    /** Temps de dessin qui suffit, en secondes ; nombres minimal et maximal de dessins. */
    private static final double ASSEZ = 1.5;
    private static final int MOINS = 4;
    private static final int PLUS = 40;
    /** Quantile à 97,5 % de la loi normale. */
    private static final double NORMALE = 1.96;

    public final Reglages reglages;
    /** En niveaux, avec leur intervalle à 95 %. */
    final double erreur;
    final double incertitude;
    private final double[] secondes;
    /** La seconde moitié des temps, du plus petit au plus grand : comme par {@code --repeter}. */
    private final double[] gardes;

    private Essai(Reglages reglages, double erreur, double incertitude, double... secondes) {
        this.reglages = reglages;
        this.erreur = erreur;
        this.incertitude = incertitude;
        this.secondes = secondes;
        gardes = Arrays.stream(secondes).skip(secondes.length / 2).sorted().toArray();
    }

    /** Un réglage qui n'est pas encore dessiné. */
    public Essai(Reglages reglages) {
        this(reglages, 0, 0);
    }

    /** Le même, dessiné une fois de plus. */
    public Essai avec(double duree, double sonErreur, double sonIncertitude) {
        double[] suite = Arrays.copyOf(secondes, secondes.length + 1);
        suite[secondes.length] = duree;
        return new Essai(reglages, sonErreur, sonIncertitude, suite);
    }

    public int getNombre() {
        return secondes.length;
    }

    public boolean suffit() {
        return secondes.length >= PLUS || secondes.length >= MOINS && Arrays.stream(secondes).sum() >= ASSEZ;
    }

    /** La médiane des temps gardés, en secondes. */
    double getTemps() {
        return (gardes[(gardes.length - 1) / 2] + gardes[gardes.length / 2]) / 2;
    }

    /** Le plus petit temps de l'intervalle de la médiane, à 95 % s'il y a assez de temps gardés. */
    double getMin() {
        return gardes[(int) Math.max(0, (gardes.length - NORMALE * Math.sqrt(gardes.length)) / 2)];
    }

    double getMax() {
        return gardes[gardes.length - 1 - (int) Math.max(0, (gardes.length - NORMALE * Math.sqrt(gardes.length)) / 2)];
    }

    /** Le temps et l'erreur, avec leurs intervalles. */
    public String dire() {
        return String.format(Locale.FRANCE, "%.3f s (de %.3f à %.3f), " + (erreur > 0 ? "erreur de %.2f ± %.2f niveaux"
                : "aucun écart vu"), getTemps(), getMin(), getMax(), erreur, incertitude);
    }

    /** Le nom court de ce réglage. */
    String getNom() {
        if (reglages.getEssayee() == null) {
            return nombre(reglages.getProfondeur()) + (reglages.getProfondeur() > 1 ? " réflexions" : " réflexion");
        }
        Section section = reglages.getSectionEntiere(reglages.getEssayee());
        return "1".equals(section.valeur("n")) ? "un rayon" : section.valeur("methode") + " n=" + section.valeur("n");
    }

    static String nombre(double t) {
        return t >= 10 ? String.format(Locale.FRANCE, "%.0f", t)
                : String.format(Locale.FRANCE, "%.3f", t).replaceAll(",?0+$", "");
    }
}
