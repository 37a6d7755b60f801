package lancer.atelier;

import java.io.IOException;
import java.math.BigDecimal;

/**
 * Écrit une scène au fil de l'eau : quelques dizaines de kilo-octets en mémoire, quel que soit le nombre de sphères. Les
 * nombres ne dépendent pas de la langue de la machine.
 */
final class Plume {

    /** Caractères gardés avant d'être confiés à la sortie. */
    private static final int TAMPON = 1 << 15;

    /** Décimales écrites, zéros de fin retirés : assez pour la plus petite boule d'une foule de cent millions. */
    private static final int DECIMALES = 9;
    private static final double UNITE = 1e9;
    /** Au-delà, un multiple de 1e-9 ne tient plus dans un {@code long}. */
    private static final double MAX = 9e9;

    private final Appendable sortie;
    private final StringBuilder tampon = new StringBuilder(TAMPON + 1024);
    private int spheres;

    Plume(Appendable sortie) {
        this.sortie = sortie;
    }

    void commentaires(String... lignes) {
        for (String ligne : lignes) {
            tampon.append(ligne.isEmpty() ? ";" : "; ").append(ligne).append('\n');
        }
    }

    /** Une sphère, numérotée dans l'ordre d'écriture. */
    void sphere(double x, double y, double z, double rayon, String materiau) throws IOException {
        sphere(Integer.toString(++spheres), x, y, z, rayon, materiau);
    }

    /** Une sphère qui a un nom, par exemple le sol. */
    void sphere(String nom, double x, double y, double z, double rayon, String materiau) throws IOException {
        tampon.append("\n[Sphere ").append(nom).append("]\n");
        tampon.append("centre=");
        triplet(x, y, z);
        tampon.append("rayon=");
        nombre(rayon);
        tampon.append('\n').append(materiau);
        if (tampon.length() > TAMPON) {
            vider();
        }
    }

    void lampe(String nom, double x, double y, double z, double r, double v, double b) {
        tampon.append("\n[Lampe ").append(nom).append("]\nposition=");
        triplet(x, y, z);
        tampon.append("couleur=");
        triplet(r, v, b);
    }

    /** Les lignes Kd, Ks et ns d'un matériau, à donner à {@link #sphere} ; les textes d'une palette ne se font qu'une fois. */
    static String materiau(double[] kd, double[] ks, int ns) {
        Plume plume = new Plume(null);
        plume.tampon.append("Kd=");
        plume.triplet(kd[0], kd[1], kd[2]);
        plume.tampon.append("Ks=");
        plume.triplet(ks[0], ks[1], ks[2]);
        return plume.tampon.append("ns=").append(ns).append('\n').toString();
    }

    private void triplet(double x, double y, double z) {
        nombre(x);
        tampon.append(' ');
        nombre(y);
        tampon.append(' ');
        nombre(z);
        tampon.append('\n');
    }

    private void nombre(double valeur) {
        if (!(Math.abs(valeur) < MAX)) {
            throw new IllegalArgumentException("nombre trop grand : " + valeur);
        }
        tampon.append(BigDecimal.valueOf(Math.round(valeur * UNITE), DECIMALES).stripTrailingZeros().toPlainString());
    }

    void vider() throws IOException {
        sortie.append(tampon);
        tampon.setLength(0);
    }
}
