package lancer.auto;

import lancer.contrat.Echantillonnage;
import lancer.contrat.Section;

/** Façon de dessiner : un échantillonnage et une limite des reflets, l'erreur attendue et le prix. Immuable. */
public final class Candidat {

    /** Écarts types de l'attendu au promis : neuf fois sur dix, de part et d'autre, d'une loi normale. */
    static final double PRUDENCE = 1.64;

    /** Réflexions, seuil des reflets, section de variante qui donne l'échantillonnage, ou null pour la scène. */
    public final int reflets;
    public final double seuil;
    public final Section section;

    /** Attendus : l'erreur, en niveaux, entre quoi elle est neuf fois sur dix, et les rayons par pixel. */
    public final double erreur;
    public final double auMoins;
    public final double auPlus;
    public final double prix;

    final Estimation estimation;
    final Echantillonnage echantillonnage;
    private final Limite limite;

    Candidat(Section section, Echantillonnage echantillonnage, Limite limite, Estimation estimation, double prix) {
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
    }

    /** Demande de ce réglage : la section à écrire dans la scène, et les options. */
    @Override
    public String toString() {
        return (section != null ? section.toString() : echantillonnage == null ? "un rayon par pixel"
                : "l'échantillonnage de la scène") + ", " + limite;
    }
}
