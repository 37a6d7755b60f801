package lancer.contrat;

import java.util.function.DoubleFunction;
import lancer.Vecteur;
import lancer.texte.Nombre;

/** Le reflet d'une lampe (cours, « Éclairement spéculaire »). Tous les fils appellent le même objet, sans état. */
public interface Specularite {

    /** Le reflet de la base : max(0, R·L)^ns (Phong, 1975). */
    Specularite PHONG = new Specularite() {
        @Override
        public double eclat(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns) {
            return Specularite.puissance(R.dot(L), ns);
        }

        @Override
        public String dire(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns, DoubleFunction<String> nombre) {
            return Specularite.puissance("R·L", R.dot(L), ns, nombre);
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

    /** Le calcul de l'éclat, pour l'inspecteur. @param nombre écriture d'un nombre calculé */
    default String dire(Vecteur V, Vecteur N, Vecteur L, Vecteur R, double ns, DoubleFunction<String> nombre) {
        return "éclat " + nombre.apply(eclat(V, N, L, R, ns));
    }

    /** Une {@link #puissance(double, double)}, de la forme {@code (R·L 0.98)^40}. @param nom celui du cosinus */
    static String puissance(String nom, double cosinus, double exposant, DoubleFunction<String> nombre) {
        return (cosinus < 0 ? "max(0, " : "(") + nom + " " + nombre.apply(cosinus) + ")^" + Nombre.ecrire(exposant);
    }
}
