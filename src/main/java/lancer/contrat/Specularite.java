package lancer.contrat;

import lancer.Vecteur;

/** Le reflet d'une lampe (cours, « Éclairement spéculaire »). Tous les fils appellent le même objet, sans état. */
public interface Specularite {

    /** Le reflet de la base : max(0, R·L)^ns (Phong, 1975). */
    Specularite PHONG = new Specularite() {
        @Override
        public double eclat(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns) {
            return Specularite.puissance(R.dot(L), ns);
        }

        @Override
        public double base(Vecteur V, Vecteur N, Vecteur L, Vecteur R) {
            return R.dot(L);
        }
    };

    /** Exposant au-delà duquel la puissance par carrés successifs perd trop de chiffres. */
    int EXPOSANT_ENTIER_MAX = 1024;

    /**
     * Part de la lumière d'une lampe que la surface reflète. Tous les vecteurs sont de longueur 1.
     *
     * @param V direction du rayon incident
     * @param N normale au contact, vers l'extérieur
     * @param L direction de la lampe ; N·L est strictement positif
     * @param R direction réfléchie
     * @param ns exposant de la surface, dans [0, 1e9]
     * @return dans [0, 1]
     */
    double eclat(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns);

    /**
     * Puissance max(0, cosinus)^exposant, où un cosinus supérieur à 1 par arrondi compte pour 1 ; 0^0 = 1. L'exposant
     * est positif ou nul. S'il est entier et petit, le calcul se fait par carrés, à quelques unités du dernier chiffre.
     */
    static double puissance(double cosinus, double exposant) {
        if (!(cosinus > 0 && cosinus < 1)) {
            return cosinus >= 1 || exposant == 0 ? 1 : 0;
        }
        int n = (int) exposant;
        if (n != exposant || n > EXPOSANT_ENTIER_MAX) {
            return Math.pow(cosinus, exposant);
        }
        double resultat = 1;
        double carre = cosinus;
        for (int reste = n; reste != 0; reste >>= 1) {
            resultat = (reste & 1) != 0 ? resultat * carre : resultat;
            carre *= carre;
        }
        return resultat;
    }

    /** Base de la {@link #puissance} ; NaN sans elle. L'inspecteur appelle cette méthode et les deux suivantes. */
    default double base(Vecteur V, Vecteur N, Vecteur L, Vecteur R) {
        return Double.NaN;
    }

    default double exposant(double ns) {
        return ns;
    }

    default String nomDeLaBase() {
        return "R·L";
    }
}
