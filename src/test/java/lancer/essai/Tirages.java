package lancer.essai;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;

/** Des scènes et des rayons tirés au sort, les mêmes pour la même graine. */
public final class Tirages {

    public final Random hasard;

    public Tirages(long graine) {
        hasard = new Random(graine);
    }

    public double entre(double a, double b) {
        return a + (b - a) * hasard.nextDouble();
    }

    public Vecteur direction() {
        return direction(hasard);
    }

    /** Une direction au hasard, également répartie. */
    public static Vecteur direction(Random hasard) {
        return new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian()).normalized();
    }

    /** Un point à quelques unités de (0, 0, 6), où sont les scènes. */
    public Point point() {
        return new Point(entre(-4, 4), entre(-3, 3), entre(1, 12));
    }

    public Couleur couleur() {
        return new Couleur(hasard.nextDouble(), hasard.nextDouble(), hasard.nextDouble());
    }

    /**
     * Des boules de toutes tailles, qui s'interpénètrent ou non, mates, brillantes ou miroirs parfaits ; une fois sur trois un sol
     * immense, une fois sur quatre une boule qui contient tout.
     */
    public List<Sphere> boules(int n) {
        List<Sphere> boules = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            Point c = point();
            boules.add(peinte(new Sphere(c, Math.pow(10, entre(-2, 0.1)))));
        }
        if (hasard.nextInt(3) == 0) {
            double r = Math.pow(10, entre(2, 6));
            boules.add(peinte(new Sphere(new Point(0, -2.5 - r, 6), r)));
        }
        if (hasard.nextInt(4) == 0) {
            boules.add(peinte(new Sphere(new Point(0, 0, 5), 40)));
        }
        return boules;
    }

    private Sphere peinte(Sphere boule) {
        boule.setKd(hasard.nextInt(4) == 0 ? new Couleur() : couleur());
        boule.setKs(hasard.nextInt(4) == 0 ? new Couleur() : hasard.nextInt(4) == 0 ? new Couleur(1) : couleur());
        boule.setNs(new double[] {0, 1, 7.5, 60, 1e5, 1e9}[hasard.nextInt(6)]);
        return boule;
    }

    /** De 0 à 3 lampes : au large, dans la scène, sur une boule ou dans une boule, blanches ou éblouissantes. */
    public List<Lampe> lampes(List<Sphere> boules) {
        List<Lampe> lampes = new ArrayList<>();
        for (int n = hasard.nextInt(4); n > 0; n--) {
            Sphere boule = boules.get(hasard.nextInt(boules.size()));
            Point[] places = {new Point(entre(-30, 30), entre(1, 30), entre(-30, 30)), point(), boule.getCentre(),
                boule.getCentre().add(direction().mul(boule.getRayon()))};
            lampes.add(new Lampe(places[hasard.nextInt(4)], hasard.nextInt(5) == 0 ? new Couleur(1e6) : couleur()));
        }
        return lampes;
    }

    public Scene scene(int n) {
        List<Sphere> boules = boules(n);
        return new Scene(boules, lampes(boules));
    }
}
