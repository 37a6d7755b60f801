package lancer.auto;

import lancer.contrat.Echantillonnage;
import lancer.contrat.Section;

/** Un réglage essayé : son échantillonnage, sa limite des reflets, son erreur attendue et son prix. Immuable. */
public final class Candidat {

    /** Nombre d'écarts types de l'erreur attendue à ses bornes, justes neuf fois sur dix (loi normale). */
    static final double PRUDENCE = 1.64;
    /** Réflexions, seuil des reflets, section de la variante d'échantillonnage, ou {@code null} sans section. */
    public final int reflets;
    public final double seuil;
    public final Section section;
    /** L'erreur attendue, en niveaux, et ses bornes, justes neuf fois sur dix ; les rayons attendus par pixel. */
    public final double erreur;
    public final double auMoins;
    public final double auPlus;
    public final double prix;
    /** Durée moyenne d'un rayon de l'essai, en nanosecondes ; NaN sans essai. Aucun choix n'en dépend. */
    public final double nsParRayon;

    final Estimation estimation;
    final Echantillonnage echantillonnage;
    final Limite limite;

    Candidat(Section section, Echantillonnage echantillonnage, Limite limite, Estimation estimation, double prix,
            double nsParRayon) {
        this.section = section;
        this.echantillonnage = echantillonnage;
        this.limite = limite;
        this.estimation = estimation;
        reflets = limite.reflets;
        seuil = limite.seuil;
        erreur = estimation.plus(0);
        auMoins = estimation.plus(-PRUDENCE);
        auPlus = estimation.plus(PRUDENCE);
        this.prix = prix;
        this.nsParRayon = nsParRayon;
    }

    /** Texte de ce réglage : la section à écrire dans la scène, et les options. */
    @Override
    public String toString() {
        return (section != null ? section.toString() : echantillonnage == null ? "un rayon par pixel"
                : "l'échantillonnage de la scène") + ", " + limite;
    }
}
