package lancer.mesures.scenes;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Des scènes où quelques pixels portent presque toute l'erreur : une étoile dans le noir, des reflets qui saturent l'écran, des
 * étincelles, de petits miroirs lointains, les fentes d'un mur sombre, une foule de points. Le même nom donne le même texte.
 */
final class Rares {

    static final List<String> NOMS = Arrays.asList("etoile", "sature", "etincelles", "miroirs-loin", "fentes", "constellation");

    private final Appendable sortie;
    private final SplittableRandom hasard = new SplittableRandom(8);
    private int spheres;

    private Rares(Appendable sortie) {
        this.sortie = sortie;
    }

    /** @param nom un de {@link #NOMS} */
    static void ecrire(Appendable sortie, String nom) throws IOException {
        Rares scene = new Rares(sortie);
        String lampe = "1 1 1";
        if (nom.equals("etoile") || nom.equals("constellation")) {
            scene.boule(0, 0, 0, 1000, 0, 0, 1);
            for (int k = 0; k < (nom.equals("etoile") ? 1 : 40); k++) {
                scene.boule(scene.entre(-1.5, 1.5), scene.entre(-1.2, 1.2), 5, 0.012, 1, 0, 1);
            }
        } else if (nom.equals("sature")) {
            lampe = "1000 1000 1000";
            scene.boule(0, -1001, 7, 1000, 0.0005, 0, 1);
            for (int k = 0; k < 5; k++) {
                scene.boule(k - 2, -0.3, 6 + k % 2, 0.6, 0.0006, 0.05, 300);
            }
        } else if (nom.equals("etincelles")) {
            lampe = "20 20 20";
            scene.boule(0, 0, 0, 1000, 0, 0, 1);
            for (int k = 0; k < 300; k++) {
                scene.boule(scene.entre(-1.8, 1.8), scene.entre(-1.3, 1.3), scene.entre(5, 8), 0.06, 0.01, 0.3, 2000);
            }
        } else if (nom.equals("miroirs-loin")) {
            for (int k = 0; k < 60; k++) {
                scene.boule(scene.entre(-12, 12), scene.entre(-8, 0), scene.entre(40, 50), 0.25, 0.1, 0.9, 50);
            }
        } else {
            // des boules qui se touchent presque, noires, devant le ciel
            for (int k = 0; k < 21 * 17; k++) {
                scene.boule((k % 21 - 10) * 0.2 + k / 21 % 2 * 0.1, (k / 21 - 8) * 0.173, 6, 0.1145, 0.02, 0, 1);
            }
        }
        sortie.append("\n[Lampe 1]\nposition=-4 6 -3\ncouleur=" + lampe + "\n");
    }

    private double entre(double min, double max) {
        return min + (max - min) * hasard.nextDouble();
    }

    private void boule(double x, double y, double z, double rayon, double gris, double reflet, int ns) throws IOException {
        sortie.append("\n[Sphere " + ++spheres + "]\ncentre=" + Foule.triplet(x, y, z) + "rayon=" + Foule.nombre(rayon) + "\nKd="
                + Foule.triplet(gris, gris, gris) + "Ks=" + Foule.triplet(reflet, reflet, reflet) + "ns=" + ns + "\n");
    }
}
