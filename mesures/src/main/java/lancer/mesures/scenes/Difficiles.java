package lancer.mesures.scenes;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import lancer.Camera;
import lancer.Constantes;

/** Des scènes difficiles à échantillonner en 800 × 600. Le même nom donne le même texte, à l'octet près, sur toute machine. */
final class Difficiles {

    /** Des détails plus petits qu'un pixel : de la poussière, des ombres fines sur un sol, de la poussière dans des miroirs. */
    static final List<String> FINES = Arrays.asList("poussiere", "ombres-fines", "poussiere-miroirs");

    /**
     * Quelques pixels y portent presque toute l'erreur : une étoile dans le noir, des reflets qui saturent l'écran, des étincelles, de
     * petits miroirs lointains, les fentes d'un mur sombre, une foule de points.
     */
    static final List<String> RARES = Arrays.asList("etoile", "sature", "etincelles", "miroirs-loin", "fentes", "constellation");

    /** Nombre de petites boules de chaque scène fine. */
    private static final int[] GRAINS = {3000, 7000, 1500};

    private static final String DEUX_LAMPES = "\n[Lampe principale]\nposition=-3 9 -2\ncouleur=0.9 0.9 0.85\n"
            + "\n[Lampe appoint]\nposition=6 4 -4\ncouleur=0.3 0.3 0.35\n";

    private final Appendable sortie;
    private final SplittableRandom hasard;
    private int spheres;

    private Difficiles(Appendable sortie, int graine) {
        this.sortie = sortie;
        hasard = new SplittableRandom(graine);
    }

    /** @param nom un de {@link #FINES} ou de {@link #RARES} */
    static void ecrire(Appendable sortie, String nom) throws IOException {
        if (FINES.contains(nom)) {
            sortie.append("; Des détails plus petits qu'un pixel, au hasard.\n;\n; Écrite par lancer.mesures.scenes.Foule " + nom + "\n");
            new Difficiles(sortie, 52).fine(nom);
            sortie.append(DEUX_LAMPES);
        } else {
            new Difficiles(sortie, 8).rare(nom);
            String lampe = nom.equals("sature") ? "1000 1000 1000" : "1 1 1";
            sortie.append("\n[Lampe 1]\nposition=-4 6 -3\ncouleur=" + (nom.equals("etincelles") ? "20 20 20" : lampe) + "\n");
        }
    }

    private void fine(String nom) throws IOException {
        double miroir = nom.endsWith("miroirs") ? 0.8 : 0.2;
        boule(0, -1001, 7, 1000, 0.8, nom.endsWith("miroirs") ? 0.3 : 0, 40);
        for (int k = 0; k < 4; k++) {
            boule(1.4 * k - 2.1, -0.2, 6.5 + k % 2, 0.7, 0.5, miroir, 40);
        }
        for (int k = 0; k < GRAINS[FINES.indexOf(nom)]; k++) {
            grain(nom);
        }
    }

    private void grain(String nom) throws IOException {
        if (nom.equals("poussiere")) {
            double z = entre(4, 8);
            boule(entre(-1, 1) / echelle(z), entre(-0.75, 0.75) / echelle(z), z, entre(0.15, 0.6) * pixel(z), entre(0, 1), 0, 40);
        } else if (nom.equals("ombres-fines")) {
            // sur le segment de la lampe à un point du sol, hors de l'image ; l'ombre est d'un demi-pixel environ
            double x = entre(-2.5, 2.5);
            double z = entre(3, 12);
            boule(x + 0.4 * (-3 - x), -1 + 0.4 * 10, z + 0.4 * (-2 - z), entre(0.2, 0.5) * pixel(z), 0.5, 0, 40);
        } else {
            // derrière l'écran : les miroirs seuls la montrent, plusieurs fois plus petite
            boule(entre(-5, 5), entre(-1, 5), entre(-6, -0.5), entre(0.01, 0.05), entre(0, 1), 0, 40);
        }
    }

    private void rare(String nom) throws IOException {
        if (nom.equals("etoile") || nom.equals("constellation")) {
            boule(0, 0, 0, 1000, 0, 0, 1);
            for (int k = 0; k < (nom.equals("etoile") ? 1 : 40); k++) {
                boule(entre(-1.5, 1.5), entre(-1.2, 1.2), 5, 0.012, 1, 0, 1);
            }
        } else if (nom.equals("sature")) {
            boule(0, -1001, 7, 1000, 0.0005, 0, 1);
            for (int k = 0; k < 5; k++) {
                boule(k - 2, -0.3, 6 + k % 2, 0.6, 0.0006, 0.05, 300);
            }
        } else if (nom.equals("etincelles")) {
            boule(0, 0, 0, 1000, 0, 0, 1);
            for (int k = 0; k < 300; k++) {
                boule(entre(-1.8, 1.8), entre(-1.3, 1.3), entre(5, 8), 0.06, 0.01, 0.3, 2000);
            }
        } else if (nom.equals("miroirs-loin")) {
            for (int k = 0; k < 60; k++) {
                boule(entre(-12, 12), entre(-8, 0), entre(40, 50), 0.25, 0.1, 0.9, 50);
            }
        } else {
            // des boules qui se touchent presque, noires, devant le ciel
            for (int k = 0; k < 21 * 17; k++) {
                boule((k % 21 - 10) * 0.2 + k / 21 % 2 * 0.1, (k / 21 - 8) * 0.173, 6, 0.1145, 0.02, 0, 1);
            }
        }
    }

    /** Longueur, sur l'écran, d'une unité à cette profondeur. */
    private static double echelle(double z) {
        return Camera.FOCALE / (z + Camera.FOCALE);
    }

    /** Longueur, à cette profondeur, d'un pixel. */
    private static double pixel(double z) {
        return Constantes.ECHELLE / Constantes.LARGEUR_IMAGE / echelle(z);
    }

    private double entre(double min, double max) {
        return min + (max - min) * hasard.nextDouble();
    }

    private void boule(double x, double y, double z, double rayon, double gris, double reflet, int ns) throws IOException {
        sortie.append("\n[Sphere " + ++spheres + "]\ncentre=" + Foule.triplet(x, y, z) + "rayon=" + Foule.nombre(rayon) + "\nKd="
                + Foule.triplet(gris, gris, gris) + "Ks=" + Foule.triplet(reflet, reflet, reflet) + "ns=" + ns + "\n");
    }
}
