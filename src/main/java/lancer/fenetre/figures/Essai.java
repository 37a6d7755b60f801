package lancer.fenetre.figures;

import java.util.Locale;
import lancer.commande.Reglages;
import lancer.contrat.Section;
import lancer.dessin.Durees;

/** Un réglage, l'erreur de son image, et les durées de ses dessins. Immuable. */
public final class Essai {

    /** Temps de dessin et nombre de dessins qui suffisent, ou nombre qui suffit quel que soit ce temps. */
    private static final double ASSEZ_NS = 1.5e9;
    private static final int MOINS = 3;
    private static final int PLUS = 40;

    /** Erreur, en niveaux, qui s'écrirait 0,00. */
    private static final double ARRONDI = 0.005;

    public final Reglages reglages;
    public final Durees durees;
    /** En niveaux, avec leur intervalle à 95 %. */
    final double erreur;
    final double incertitude;

    public Essai(Reglages reglages, Durees durees, double erreur, double incertitude) {
        this.reglages = reglages;
        this.durees = durees;
        this.erreur = erreur;
        this.incertitude = incertitude;
    }

    /** Dit si ce réglage a été assez dessiné. */
    public boolean suffit() {
        return durees.getNombre() >= PLUS || durees.getNombre() >= MOINS && durees.getSomme() >= ASSEZ_NS;
    }

    /** Le temps et l'erreur, avec leurs intervalles. */
    public String dire() {
        String ecart = erreur < ARRONDI ? "aucun écart vu" : "erreur de %.2f ± %.2f niveaux";
        return String.format(Locale.FRANCE, "%.3f s (de %.3f à %.3f), " + ecart, durees.getMediane() / 1e9,
                durees.getMin() / 1e9, durees.getMax() / 1e9, erreur, incertitude);
    }

    /** Le nom court de ce réglage. */
    String getNom() {
        if (reglages.getEssayee() == null) {
            return reglages.getProfondeur() + (reglages.getProfondeur() > 1 ? " réflexions" : " réflexion");
        }
        Section section = reglages.getSectionEntiere(reglages.getEssayee());
        String n = section.mot("n", "");
        return "1".equals(n) ? "un rayon" : section.mot("methode", "") + " n=" + n;
    }
}
