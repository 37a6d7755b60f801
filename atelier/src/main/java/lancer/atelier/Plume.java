package lancer.atelier;

import java.io.IOException;
import java.math.BigDecimal;

/** Écrit une scène au fil de l'eau, sans en rien garder. Les nombres ne dépendent pas de la langue de la machine. */
final class Plume {

    /** Décimales écrites, zéros de fin retirés : assez pour la plus petite boule d'une foule de cent millions. */
    private static final int DECIMALES = 9;
    private static final double UNITE = 1e9;
    /** Au-delà, un multiple de 1e-9 ne tient plus dans un {@code long}. */
    private static final double MAX = 9e9;

    private final Appendable sortie;
    private int spheres;

    Plume(Appendable sortie) {
        this.sortie = sortie;
    }

    void commentaires(String... lignes) throws IOException {
        for (String ligne : lignes) {
            sortie.append(ligne.isEmpty() ? ";" : "; ").append(ligne).append('\n');
        }
    }

    /** Une sphère, numérotée dans l'ordre d'écriture. */
    void sphere(double x, double y, double z, double rayon, String materiau) throws IOException {
        sphere(Integer.toString(++spheres), x, y, z, rayon, materiau);
    }

    /** Une sphère qui a un nom, par exemple le sol. */
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

    private static String triplet(double x, double y, double z) {
        return nombre(x) + " " + nombre(y) + " " + nombre(z) + "\n";
    }

    private static String nombre(double valeur) {
        if (!(Math.abs(valeur) < MAX)) {
            throw new IllegalArgumentException("nombre trop grand : " + valeur);
        }
        return BigDecimal.valueOf(Math.round(valeur * UNITE), DECIMALES).stripTrailingZeros().toPlainString();
    }
}
