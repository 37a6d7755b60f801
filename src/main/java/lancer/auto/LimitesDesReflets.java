package lancer.auto;

import java.math.BigDecimal;

/** Jusqu'où les reflets sont suivis, l'erreur que cela fait, et ce que cela coûte. Immuable. */
final class LimitesDesReflets implements Comparable<LimitesDesReflets> {

    final int reflets;
    final double seuil;

    /** Contre les mêmes rayons sans limite ; et rayons de toutes sortes pour un rayon de l'écran, lui compris. */
    final Estimation erreur;
    final double rayons;

    LimitesDesReflets(int reflets, double seuil, Estimation erreur, double rayons) {
        this.reflets = reflets;
        this.seuil = seuil;
        this.erreur = erreur;
        this.rayons = rayons;
    }

    /** Le moindre prix d'abord, puis la moindre erreur ; au même prix, la plus profonde. */
    @Override
    public int compareTo(LimitesDesReflets autre) {
        int ordre = Double.compare(rayons, autre.rayons);
        ordre = ordre != 0 ? ordre : Double.compare(erreur.carre, autre.erreur.carre);
        return ordre != 0 ? ordre : Integer.compare(autre.reflets, reflets);
    }

    @Override
    public String toString() {
        // sans reflets, aucun seuil ne compte
        return "--reflets " + reflets + (reflets == 0 ? "" : " --seuil " + (seuil == 0 ? "0"
                : new BigDecimal(String.valueOf(seuil)).toPlainString()));
    }
}
