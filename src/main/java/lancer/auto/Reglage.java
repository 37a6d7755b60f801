package lancer.auto;

/** Un échantillonnage et des limites : tout ce qu'il faut pour dessiner, l'erreur attendue et le prix. */
public final class Reglage {

    final Finesse finesse;
    final LimitesDesReflets limites;

    Reglage(Finesse finesse, LimitesDesReflets limites) {
        this.finesse = finesse;
        this.limites = limites;
    }

    private Estimation erreur() {
        // ce qui manque aux reflets et ce qui manque aux pixels sont sans rapport
        return finesse.erreur.plus(limites.erreur);
    }

    /** L'erreur attendue, en niveaux, contre la moyenne du pixel sans limite de réflexions. */
    public double getErreur() {
        return erreur().erreur();
    }

    /** Ce que l'erreur ne devrait pas dépasser, en niveaux. */
    public double getErreurAuPlus() {
        return erreur().auPlus();
    }

    /** L'erreur sur laquelle choisir : celle à ne pas dépasser s'il est bien essayé, celle qu'il semble faire sinon. */
    double getErreurRetenue() {
        return finesse.sure ? getErreurAuPlus() : getErreur();
    }

    /** Rayons de l'écran par pixel, attendus. */
    public double getRayons() {
        return finesse.rayons;
    }

    /** Rayons de toutes sortes par pixel, attendus. */
    public double getPrix() {
        return finesse.prix * limites.rayons;
    }

    /** Le nombre de réflexions d'un rayon. */
    public int getReflets() {
        return limites.reflets;
    }

    /** Comme on le demanderait soi-même : la section à écrire dans la scène, et les options. */
    @Override
    public String toString() {
        return finesse.texte + ", " + limites;
    }
}
