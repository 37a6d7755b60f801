package lancer.mesures.scenes;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;

/** Écrit une scène au fil de l'eau, sans en rien garder. Les nombres ne dépendent pas de la langue de la machine. */
final class Plume {

    /** Décimales écrites, zéros de fin retirés : assez pour la plus petite boule d'une foule de cent millions. */
    private static final int DECIMALES = 9;

    private final Appendable sortie;

    Plume(Appendable sortie) {
        this.sortie = sortie;
    }

    void commentaires(String... lignes) throws IOException {
        for (String ligne : lignes) {
            sortie.append(ligne.isEmpty() ? ";" : "; ").append(ligne).append('\n');
        }
    }

    /** Une sphère, et ce qui la distingue des autres : un nom ou un rang. */
    void sphere(String nom, double x, double y, double z, double rayon, String materiau) throws IOException {
        sortie.append("\n[Sphere " + nom + "]\ncentre=" + triplet(x, y, z) + "rayon=" + nombre(rayon) + "\n" + materiau);
    }

    void lampe(String nom, double x, double y, double z, double r, double v, double b) throws IOException {
        sortie.append("\n[Lampe " + nom + "]\nposition=" + triplet(x, y, z) + "couleur=" + triplet(r, v, b));
    }

    /** Les lignes Kd, Ks et ns d'un matériau, à donner à {@link #sphere} ; les textes d'une palette ne se font qu'une fois. */
    static String materiau(double[] kd, double[] ks, int ns) {
        return "Kd=" + triplet(kd[0], kd[1], kd[2]) + "Ks=" + triplet(ks[0], ks[1], ks[2]) + "ns=" + ns + "\n";
    }

    /**
     * Une couleur par sa teinte, plus facile à accorder que rouge, vert et bleu.
     *
     * @param teinte en tours : 0 rouge, 1/3 vert, 2/3 bleu
     * @param vivacite 0 gris, 1 vif
     * @param clarte la plus grande des trois composantes
     * @return rouge, vert, bleu, au millième
     */
    static double[] couleur(double teinte, double vivacite, double clarte) {
        double[] rvb = new double[3];
        for (int i = 0; i < 3; i++) {
            double ecart = teinte - i / 3.0;
            // distance à la composante pure sur le cercle des teintes, de 0 à 1/2
            double distance = Math.abs(ecart - Math.rint(ecart));
            double presence = Math.max(0, Math.min(1, 2 - 6 * distance));
            rvb[i] = Math.rint(1000 * clarte * (1 - vivacite * (1 - presence))) / 1000;
        }
        return rvb;
    }

    private static String triplet(double x, double y, double z) {
        return nombre(x) + " " + nombre(y) + " " + nombre(z) + "\n";
    }

    private static String nombre(double valeur) {
        return BigDecimal.valueOf(valeur).setScale(DECIMALES, RoundingMode.HALF_UP).stripTrailingZeros().toPlainString();
    }
}
