package lancer.auto;

import lancer.contrat.Section;

/** Un échantillonnage et des limites : de quoi dessiner, l'erreur attendue et le prix. Immuable. */
public final class Reglage {

    /** Le nombre de réflexions d'un rayon, et sous quel produit des Ks un reflet n'est plus suivi. */
    public final int reflets;
    public final double seuil;

    /** La section de variante qui donne l'échantillonnage ; {@code null} pour celui de la scène. */
    public final Section section;

    /** L'erreur attendue, en niveaux, contre la moyenne du pixel sans limite de réflexions. */
    public final double erreur;

    /** Ce que l'erreur ne devrait pas dépasser. */
    public final double erreurAuPlus;

    /** Entre quoi doit tomber, dix-neuf fois sur vingt, l'erreur mesurée de l'image, qui a son incertitude aussi. */
    public final double mesureAuMoins;
    public final double mesureAuPlus;

    /** Rayons de l'écran par pixel, attendus, et rayons de toutes sortes. */
    public final double rayons;
    public final double prix;

    final Finesse finesse;
    final LimitesDesReflets limites;

    Reglage(Finesse finesse, LimitesDesReflets limites) {
        this.finesse = finesse;
        this.limites = limites;
        reflets = limites.reflets;
        seuil = limites.seuil;
        section = finesse.section;
        // ce qui manque aux reflets et ce qui manque aux pixels sont sans rapport
        Estimation estimation = finesse.erreur.plus(limites.erreur);
        erreur = estimation.erreur();
        erreurAuPlus = estimation.auPlus();
        mesureAuMoins = estimation.mesuree().auMoins();
        mesureAuPlus = estimation.mesuree().auPlus();
        rayons = finesse.rayons;
        prix = finesse.prix * limites.rayons;
    }

    /** Comme on le demanderait soi-même : la section à écrire dans la scène, et les options. */
    @Override
    public String toString() {
        return finesse + ", " + limites;
    }
}
