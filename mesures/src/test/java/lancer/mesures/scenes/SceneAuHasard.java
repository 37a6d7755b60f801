package lancer.mesures.scenes;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;

/**
 * Une scène aléatoire, d'une à mille sphères : mates ou réfléchissantes, grosses ou petites, éparses ou serrées, avec ou sans sol, sous une
 * à trois lampes. La même graine donne la même scène.
 */
public final class SceneAuHasard {

    private static final int BOULES_MAX = 1000;
    private static final double RAYON_DU_SOL = 1000;

    /** {@link java.util.Random} donne presque le même premier nombre à deux graines voisines ; ce générateur, non. */
    private final SplittableRandom hasard;

    private SceneAuHasard(long graine) {
        hasard = new SplittableRandom(graine);
    }

    public static Scene de(long graine) {
        return new SceneAuHasard(graine).scene();
    }

    private Scene scene() {
        List<Sphere> boules = new ArrayList<>();
        int nombre = (int) Math.pow(BOULES_MAX, hasard.nextDouble());
        double etendue = entre(1, 4);
        // plus les sphères sont nombreuses, plus elles sont petites ; elles couvrent de presque rien à tout l'écran
        double rayon = etendue * entre(0.1, 0.8) / Math.sqrt(nombre);
        // probabilité qu'une sphère soit réfléchissante
        double brillant = hasard.nextDouble();
        double miroir = hasard.nextInt(3) == 0 ? 0.95 : 0.5;
        for (int k = 0; k < nombre; k++) {
            double taille = rayon * Math.exp(entre(-1, 1));
            boules.add(boule(new Point(entre(-etendue, etendue), entre(-etendue, etendue), 5 + entre(0, 2 * etendue)), taille,
                    hasard.nextDouble() < brillant ? entre(0.05, miroir) : 0));
        }
        if (hasard.nextBoolean()) {
            boules.add(boule(new Point(0, -RAYON_DU_SOL - entre(0.5, 2), 8), RAYON_DU_SOL, hasard.nextInt(3) == 0 ? miroir : 0));
        }
        List<Lampe> lampes = new ArrayList<>();
        int combien = 1 + hasard.nextInt(3);
        for (int k = 0; k < combien; k++) {
            lampes.add(new Lampe(new Point(entre(-10, 10), entre(0, 12), entre(-10, 8)), couleur(0.3, 1)));
        }
        return new Scene(boules, lampes);
    }

    private Sphere boule(Point centre, double rayon, double reflet) {
        Sphere boule = new Sphere(centre, rayon);
        boule.setKd(couleur(0.1, 1));
        boule.setKs(new Couleur(reflet));
        boule.setNs(Math.exp(entre(0, 6)));
        return boule;
    }

    private Couleur couleur(double min, double max) {
        return new Couleur(entre(min, max), entre(min, max), entre(min, max));
    }

    private double entre(double min, double max) {
        return min + (max - min) * hasard.nextDouble();
    }
}
