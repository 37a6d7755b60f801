package lancer.auto;

import java.util.Locale;

/** Ce qui est voulu d'une image, et ce qui est fixé d'avance : le reste est à choisir. Immuable. */
public final class Souhait {

    /** L'erreur voulue, en niveaux ; 0 si c'est un temps qui est voulu. */
    final double erreur;

    /** Le temps voulu, essais et dessin, en secondes. */
    final double temps;

    /** {@code null} : à choisir. */
    final Integer reflets;
    final Double seuil;

    private Souhait(double erreur, double temps, Integer reflets, Double seuil) {
        this.erreur = erreur;
        this.temps = temps;
        this.reflets = reflets;
        this.seuil = seuil;
    }

    /** Au meilleur prix, une erreur d'au plus tant de niveaux. */
    public static Souhait erreur(double niveaux) {
        return new Souhait(niveaux, 0, null, null);
    }

    /** Au plus juste, une image en au plus tant de secondes, essais compris. */
    public static Souhait temps(double secondes) {
        return new Souhait(0, secondes, null, null);
    }

    /** Le même, à tant de réflexions et à ce seuil ; {@code null} pour celui des deux qui reste à choisir. */
    public Souhait fixer(Integer reflets, Double seuil) {
        return new Souhait(erreur, temps, reflets, seuil);
    }

    /** Vrai si c'est ce qui est voulu, ou mieux. */
    boolean estTenu(double erreur, double temps) {
        return this.erreur > 0 ? erreur <= this.erreur : temps <= this.temps;
    }

    @Override
    public String toString() {
        return erreur > 0 ? String.format(Locale.ROOT, "une erreur de %.2f", erreur)
                : String.format(Locale.ROOT, "%.3f s", temps);
    }
}
