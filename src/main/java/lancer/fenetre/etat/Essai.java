package lancer.fenetre.etat;

import java.util.Locale;
import lancer.Constantes;
import lancer.auto.Echelle;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.Variante;
import lancer.dessin.Durees;
import lancer.texte.Nombre;

/** Un réglage, l'erreur de son image, et les durées de ses dessins. Immuable. */
public final class Essai {

    /** Temps de dessin et nombre de dessins qui suffisent, ou nombre qui suffit quel que soit ce temps. */
    private static final double ASSEZ_NS = 1.5e9;
    private static final int MOINS = 3;
    private static final int PLUS = 40;

    /** Largeur de l'intervalle d'un temps, en part de ce temps, qui dit une machine occupée. */
    private static final double VARIATION = 0.3;

    /** Erreur, en niveaux, qui s'écrirait 0,00. */
    private static final double ARRONDI = 0.005;

    public final Reglages reglages;
    public final Durees durees;
    /** En niveaux, avec leur intervalle à 95 %. */
    public final double erreur;
    public final double incertitude;

    public Essai(Reglages reglages, Durees durees, double erreur, double incertitude) {
        this.reglages = reglages;
        this.durees = durees;
        this.erreur = erreur;
        this.incertitude = incertitude;
    }

    public boolean estFait() {
        return durees.getNombre() > 0;
    }

    /** Le nombre de dessins qui suffiront, d'après ceux qui sont faits. */
    public int getVoulus() {
        double suffisants = durees.getNombre() == 0 ? MOINS : ASSEZ_NS * durees.getNombre() / durees.getSomme();
        return (int) Math.max(MOINS, Math.min(PLUS, Math.ceil(suffisants)));
    }

    /** Dit si ce réglage a été assez dessiné. */
    public boolean suffit() {
        return durees.getNombre() >= getVoulus();
    }

    /** Dit si ses temps, assez nombreux, varient trop pour une machine qui ne fait rien d'autre. */
    public boolean varie() {
        return suffit() && durees.getMax() - durees.getMin() > VARIATION * durees.getMediane();
    }

    /** Ce réglage, en mots : ce qui est le même à tous les échelons n'y est pas. */
    public String direLeReglage() {
        int reflets = reglages.getProfondeur();
        double seuil = reglages.get(Option.SEUIL);
        return Echelle.direLEchantillonnage(reglages) + ", " + reflets + (reflets > 1 ? " réflexions" : " réflexion")
                + (seuil == Constantes.SEUIL ? "" : ", seuil " + Nombre.enFraction(seuil));
    }

    /** Le temps et l'erreur, avec leurs intervalles. */
    public String dire() {
        String ecart = estVue() ? "erreur de %.2f ± %.2f niveaux" : "aucun écart vu";
        return String.format(Locale.FRANCE, "%.3f s (de %.3f à %.3f), " + ecart, durees.getMediane() / 1e9,
                durees.getMin() / 1e9, durees.getMax() / 1e9, erreur, incertitude);
    }

    /** Dit si une erreur a été vue. */
    public boolean estVue() {
        return erreur >= ARRONDI;
    }

    /** Le nom court de ce réglage, que n'a aucun autre de son échelle. */
    public String getNom() {
        Variante essayee = reglages.getEssayee();
        if (essayee != null) {
            return essayee.getNomCourt(reglages.getSectionEntiere(essayee));
        }
        return reglages.getProfondeur() + (reglages.getProfondeur() > 1 ? " réflexions" : " réflexion");
    }
}
