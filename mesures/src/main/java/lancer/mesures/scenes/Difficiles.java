package lancer.mesures.scenes;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import lancer.Camera;
import lancer.Constantes;

/**
 * Trois scènes dont les détails sont plus petits qu'un pixel en 800 × 600 : de la poussière devant l'œil, des ombres fines sur un sol, de la
 * poussière vue seulement dans des miroirs. Le même nom donne le même texte, à l'octet près, sur toute machine.
 */
final class Difficiles {

    static final List<String> NOMS = Arrays.asList("poussiere", "ombres-fines", "poussiere-miroirs");

    /** Nombre de petites boules de chaque scène. */
    private static final int[] GRAINS = {3000, 7000, 1500};

    private final Appendable sortie;
    private final SplittableRandom hasard = new SplittableRandom(52);
    private int spheres;

    private Difficiles(Appendable sortie) {
        this.sortie = sortie;
    }

    /** @param nom un de {@link #NOMS} */
    static void ecrire(Appendable sortie, String nom) throws IOException {
        sortie.append("; Des détails plus petits qu'un pixel, au hasard.\n;\n; Écrite par lancer.mesures.scenes.Foule " + nom + "\n");
        Difficiles scene = new Difficiles(sortie);
        double miroir = nom.endsWith("miroirs") ? 0.8 : 0.2;
        scene.boule(0, -1001, 7, 1000, 0.8, nom.endsWith("miroirs") ? 0.3 : 0);
        for (int k = 0; k < 4; k++) {
            scene.boule(1.4 * k - 2.1, -0.2, 6.5 + k % 2, 0.7, 0.5, miroir);
        }
        for (int k = 0; k < GRAINS[NOMS.indexOf(nom)]; k++) {
            scene.grain(nom);
        }
        sortie.append("\n[Lampe principale]\nposition=-3 9 -2\ncouleur=0.9 0.9 0.85\n"
                + "\n[Lampe appoint]\nposition=6 4 -4\ncouleur=0.3 0.3 0.35\n");
    }

    private void grain(String nom) throws IOException {
        if (nom.equals("poussiere")) {
            double z = entre(4, 8);
            boule(entre(-1, 1) / echelle(z), entre(-0.75, 0.75) / echelle(z), z, entre(0.15, 0.6) * pixel(z), entre(0, 1), 0);
        } else if (nom.equals("ombres-fines")) {
            // sur le segment de la lampe à un point du sol, hors de l'image ; l'ombre est d'un demi-pixel environ
            double x = entre(-2.5, 2.5);
            double z = entre(3, 12);
            boule(x + 0.4 * (-3 - x), -1 + 0.4 * 10, z + 0.4 * (-2 - z), entre(0.2, 0.5) * pixel(z), 0.5, 0);
        } else {
            // derrière l'écran : les miroirs seuls la montrent, plusieurs fois plus petite
            boule(entre(-5, 5), entre(-1, 5), entre(-6, -0.5), entre(0.01, 0.05), entre(0, 1), 0);
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

    private void boule(double x, double y, double z, double rayon, double gris, double reflet) throws IOException {
        sortie.append("\n[Sphere " + ++spheres + "]\ncentre=" + Foule.triplet(x, y, z) + "rayon=" + Foule.nombre(rayon) + "\nKd="
                + Foule.triplet(gris, gris, gris) + "Ks=" + Foule.triplet(reflet, reflet, reflet) + "ns=40\n");
    }
}
