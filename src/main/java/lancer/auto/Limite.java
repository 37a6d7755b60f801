package lancer.auto;

import java.math.BigDecimal;
import java.util.Arrays;

/** Limite des rayons réfléchis, avec l'erreur qu'elle cause et son prix. */
final class Limite {

    private static final double[] SEUILS = {1.0 / 16, 1.0 / 64, 1.0 / 256, 0};
    /** Nombre de pixels des essais, et part du carré de l'erreur voulue que celui des reflets peut atteindre. */
    private static final int PIXELS = 500;
    private static final double PART = 0.15;

    final int reflets;
    final double seuil;
    /** Le carré de l'erreur, en niveaux², et le nombre de rayons de toutes sortes pour un rayon de l'écran. */
    private double carre;
    double rayons = 1;

    private Limite(int reflets, double seuil) {
        this.reflets = reflets;
        this.seuil = seuil;
    }

    /** Limites, de la plus étroite à la plus large. Un argument {@code null} est à choisir. */
    static Limite[] permises(Integer reflets, Double seuil) {
        return Arrays.stream(seuil == null ? SEUILS : new double[] {seuil})
                .mapToObj(s -> new Limite(reflets == null ? Essais.PROFONDEUR : reflets, s)).toArray(Limite[]::new);
    }

    /** Essaie cette limite sur quelques pixels de l'échantillon pilote, un rayon par pixel. */
    void essayer(Essais essais, EchantillonPilote pilote, double permis) {
        // un pas impair décale les pixels choisis d'un carreau à l'autre
        int pas = pilote.pixels.length / PIXELS | 1;
        double[] carres = new double[pilote.pixels.length / pas];
        double avant = essais.rayons.get();
        int faits = essais.passer(carres.length, reflets, seuil, permis, (k, vue) -> {
            double[] vu = pilote.centre(pilote.pixels[k * pas], vue);
            carres[k] = EchantillonPilote.produit(vu, pilote.niveaux[k * pas], pilote.niveaux[k * pas]);
        });
        carre = Arrays.stream(carres, 0, faits).average().orElse(0);
        rayons = (essais.rayons.get() - avant) / Math.max(1, faits);
    }

    /** La limite la moins chère dont l'erreur est une petite part de {@code erreur} ou, à défaut, la plus large. */
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
