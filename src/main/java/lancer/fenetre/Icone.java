package lancer.fenetre;

import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;

/** L'icône du programme : trois des boules de la scène du cours, dessinées par lui. */
final class Icone {

    private static final int[] COTES = {16, 32, 48, 128};

    private Icone() {
    }

    /** La même à plusieurs tailles, entre lesquelles le bureau choisit. */
    static List<Image> dessiner() {
        Scene scene = new Scene(Arrays.asList(boule(0, -100.6, 4, 100, new Couleur(0.7, 0.6, 0.5)),
                boule(-0.4, -0.1, 2.2, 0.5, new Couleur(0.7, 0.05, 0.15)),
                boule(0.45, -0.2, 1.9, 0.4, new Couleur(0.05, 0.2, 0.8)),
                boule(0, -0.4, 1, 0.2, new Couleur(0.7, 0.4, 0.05))),
                Collections.singletonList(new Lampe(new Point(-4, 6, -3), new Couleur(1))));
        List<Image> icones = new ArrayList<>();
        for (int cote : COTES) {
            BufferedImage icone = new BufferedImage(cote, cote, BufferedImage.TYPE_INT_RGB);
            new Lancer(scene, new Camera(cote, cote)).TracerPixels(
                    (couleur, xe, ye) -> icone.setRGB(xe, ye, couleur.getCode()), Constantes.MAX_REFLETS, 1);
            icones.add(icone);
        }
        return icones;
    }

    private static Sphere boule(double x, double y, double z, double rayon, Couleur kd) {
        Sphere boule = new Sphere(new Point(x, y, z), rayon);
        boule.setKd(kd);
        boule.setKs(new Couleur(0.25));
        boule.setNs(40);
        return boule;
    }
}
