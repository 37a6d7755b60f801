package lancer.auto;

import java.math.BigDecimal;
import java.util.Arrays;

/** Limite jusqu'où les reflets sont suivis, l'erreur que cela fait, et ce que cela coûte. */
final class Limite {

    private static final double[] SEUILS = {1.0 / 16, 1.0 / 64, 1.0 / 256, 0};

    /** Pixels où les essayer, et la part du carré de l'erreur visée qui peut leur revenir. */
    private static final int PIXELS = 1000;
    private static final double PART = 0.15;

    final int reflets;
    final double seuil;

    /** Le carré de l'erreur, en niveaux², et rayons de toutes sortes pour un rayon de l'écran, lui compris. */
    private double carre;
    double rayons = 1;

    private Limite(int reflets, double seuil) {
        this.reflets = reflets;
        this.seuil = seuil;
    }

    /** Limites, de la plus étroite à la plus large. @param reflets {@code null} : à choisir ; de même le seuil */
    static Limite[] permises(Integer reflets, Double seuil) {
        return Arrays.stream(seuil == null ? SEUILS : new double[] {seuil})
                .mapToObj(s -> new Limite(reflets == null ? Essais.PROFONDEUR : reflets, s)).toArray(Limite[]::new);
    }

    /** Essaie celle-ci sur un rayon de quelques pixels du semis, autant que le permettent ces rayons. */
    void essayer(Essais essais, Semis semis, double permis) {
        // impair, pour ne pas tomber toujours au même endroit d'un carreau
        int pas = semis.pixels.length / PIXELS | 1;
        double[] carres = new double[semis.pixels.length / pas];
        double avant = essais.rayons.get();
        int faits = essais.passer(carres.length, reflets, seuil, permis, (k, vue) -> {
            int pixel = semis.pixels[k * pas];
            double[] vu = Semis.niveaux(vue.couleur(pixel % semis.largeur + 0.5, pixel / semis.largeur + 0.5));
            carres[k] = Semis.produit(vu, semis.niveaux[k * pas], semis.niveaux[k * pas]);
        });
        carre = Arrays.stream(carres, 0, faits).average().orElse(0);
        rayons = (essais.rayons.get() - avant) / Math.max(1, faits);
    }

    /** La moins chère qui laisse à l'échantillonnage presque toute cette erreur ; au même prix, la plus large. */
    static Limite pour(double erreur, Limite... limites) {
        Limite choisie = limites[0];
        for (Limite limite : limites) {
            boolean mieux = choisie.carre > PART * erreur * erreur || limite.rayons <= choisie.rayons;
            choisie = mieux ? limite : choisie;
        }
        return choisie;
    }

    @Override
    public String toString() {
        return "--reflets " + reflets + " --seuil " + BigDecimal.valueOf(seuil).toPlainString();
    }
}
