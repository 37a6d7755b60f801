package lancer.contrat;

import lancer.Vecteur;

/**
 * Le reflet d'une lampe sur une surface brillante (cours, « Éclairement spéculaire »). Appelé par tous les fils à la
 * fois : une spécularité n'a pas d'état.
 */
public interface Specularite {

    /** Le reflet de la base : max(0, R·L)^ns. */
    Specularite PHONG = new Phong(null);

    /** Exposant au-delà duquel la puissance entière perdrait plus de chiffres qu'elle ne gagnerait de temps. */
    int EXPOSANT_ENTIER_MAX = 1024;

    /**
     * Part de la lumière d'une lampe que la surface reflète. Tous les vecteurs sont de longueur 1.
     *
     * @param V direction du rayon incident
     * @param N normale au contact, vers l'extérieur
     * @param L direction de la lampe ; N·L est strictement positif
     * @param R miroir de V
     * @param ns poli de la surface, dans [0, 1e9]
     * @return dans [0, 1], fini
     */
    double eclat(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns);

    /**
     * Puissance max(0, cosinus)^exposant, le cosinus ne comptant jamais pour plus de 1 (deux vecteurs de longueur 1 à
     * un arrondi près ont un produit qui peut dépasser 1) ; 0^0 = 1. Un petit exposant entier se fait par carrés
     * successifs, à quelques unités du dernier chiffre.
     *
     * @param exposant positif ou nul
     */
    static double puissance(double cosinus, double exposant) {
        if (exposant == 0) {
            return 1;
        }
        if (!(cosinus > 0)) {
            return 0;
        }
        if (cosinus >= 1) {
            return 1;
        }
        int n = (int) exposant;
        if (n != exposant || n > EXPOSANT_ENTIER_MAX) {
            return Math.pow(cosinus, exposant);
        }
        double resultat = 1;
        double carre = cosinus;
        for (int reste = n; ; carre *= carre) {
            if ((reste & 1) != 0) {
                resultat *= carre;
            }
            reste >>= 1;
            if (reste == 0) {
                return resultat;
            }
        }
    }

    /**
     * Reflet identique, qui dit à {@code ecoute} sa base et son exposant ({@link Ecoute#auReflet}) ; par défaut, il ne
     * dit rien.
     */
    default Specularite quiDit(Ecoute ecoute) {
        return this;
    }

    /** Nom de la base qu'il dit. */
    default String nomDeLaBase() {
        return "R·L";
    }

    /** Reflet de Phong, 1975. */
    final class Phong implements Specularite {

        private final Ecoute ecoute;

        private Phong(Ecoute ecoute) {
            this.ecoute = ecoute;
        }

        @Override
        public double eclat(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns) {
            double base = R.dot(L);
            Ecoute.reflet(ecoute, base, ns);
            return puissance(base, ns);
        }

        @Override
        public Specularite quiDit(Ecoute autre) {
            return new Phong(autre);
        }
    }
}
