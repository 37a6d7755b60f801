package lancer.auto;

import lancer.contrat.Section;

/** Un échantillonnage et des limites : de quoi dessiner, l'erreur attendue et le prix. */
public final class Reglage {

    final Finesse finesse;
    final LimitesDesReflets limites;
    private final Estimation erreur;
    private final double rayonsParRayon;

    /** @param rayonsParRayon de toutes sortes pour un rayon de l'écran, sous ces limites */
    Reglage(Finesse finesse, LimitesDesReflets limites, double rayonsParRayon) {
        this.finesse = finesse;
        this.limites = limites;
        this.rayonsParRayon = rayonsParRayon;
        // ce qui manque aux reflets et ce qui manque aux pixels sont sans rapport
        erreur = finesse.erreur.plus(limites.erreur);
    }

    /** L'erreur attendue, en niveaux, contre la moyenne du pixel sans limite de réflexions. */
    public double getErreur() {
        return erreur.erreur();
    }

    /** Ce que l'erreur ne devrait pas dépasser, en niveaux. */
    public double getErreurAuPlus() {
        return erreur.auPlus();
    }

    /** Rayons de l'écran par pixel, attendus. */
    public double getRayons() {
        return finesse.rayons;
    }

    /** Rayons de toutes sortes par pixel, attendus. */
    public double getPrix() {
        return finesse.prix * rayonsParRayon;
    }

    /** Le nombre de réflexions d'un rayon. */
    public int getReflets() {
        return limites.reflets;
    }

    /** Sous quel produit des Ks un reflet n'est plus suivi. */
    public double getSeuil() {
        return limites.seuil;
    }

    /** La section de variante qui donne l'échantillonnage ; {@code null} pour celui de la scène. */
    public Section getSection() {
        return finesse.section;
    }

    /** Ce dont l'erreur attendue peut s'écarter, en niveaux, dix-neuf fois sur vingt. */
    public double getIncertitude() {
        return erreur.incertitude();
    }

    /** Vrai si l'erreur attendue est moindre, et celle à ne pas dépasser aussi. */
    boolean estPlusJusteQue(Reglage autre) {
        return getErreur() < autre.getErreur() && getErreurAuPlus() < autre.getErreurAuPlus();
    }

    /** Ce que chaque rayon de plus que l'autre retire de carré de l'erreur. */
    double gain(Reglage autre) {
        double retire = autre.erreur.carre() - erreur.carre();
        double prix = getPrix() - autre.getPrix();
        return prix > 0 ? retire / prix : Math.copySign(Double.POSITIVE_INFINITY, retire);
    }

    /** Comme on le demanderait soi-même : la section à écrire dans la scène, et les options. */
    @Override
    public String toString() {
        return finesse.texte + ", " + limites;
    }
}
