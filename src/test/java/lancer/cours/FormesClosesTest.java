package lancer.cours;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.imageRapide;
import static lancer.essai.Ressources.scene;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Collections;
import java.util.Random;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;

/** Des quantités que la géométrie donne sans dessiner. {@link TheorieTest} a les autres. E est l'œil, F la focale, sin α = r/|EC|. */
class FormesClosesTest {

    private static final double F = Camera.FOCALE;
    private static final Lampe A_L_OEIL = new Lampe(Camera.OEIL, new Couleur(1));

    /** La somme des pixels d'une sphère dans l'axe, la lampe à l'œil : π F² (2α/sin 2α − 1)(L/2)². */
    @Test
    void lIntegraleDeLambertSurUneSphereEstConnue() {
        int cote = 400;
        for (double r : new double[] {0.7, 1.2, 1.9}) {
            Ressources.Image image = imageRapide(scene(Collections.singletonList(boule(0, 0, 5, r, 1, 0, 1)), A_L_OEIL),
                    new Camera(cote, cote), 0);
            double somme = 0;
            for (int k = 0; k < cote * cote; k++) {
                // le ciel a un bleu d'au moins 0,1 de plus ou de moins que son rouge ; la boule est grise
                float rouge = image.composantes[3 * k];
                somme += rouge == image.composantes[3 * k + 2] ? rouge : 0;
            }
            double alpha = Math.asin(r / (5 + F));
            double attendue = Math.PI * F * F * (2 * alpha / Math.sin(2 * alpha) - 1) * cote * cote / 4;
            assertEquals(1, somme / attendue, 1e-4, "rayon " + r);
        }
    }

    /** La silhouette est une ellipse de demi-axes F sin α cos α/(cos²θ − sin²α), vers l'axe, et F sin α/√(cos²θ − sin²α). */
    @Test
    void lesDemiAxesDeLaSilhouetteSontConnus() {
        for (double[] c : new double[][] {{1, 0.5, 5}, {-0.7, 0.9, 4}, {0.01, 0, 6}, {2, -2, 9}}) {
            Sphere sphere = new Sphere(new Point(c[0], c[1], c[2]), 0.8);
            double D = new Vecteur(Camera.OEIL, sphere.getCentre()).norme();
            double sin2 = 0.64 / (D * D);
            double cosTheta = (c[2] + F) / D;
            double theta = Math.acos(cosTheta);
            double alpha = Math.asin(0.8 / D);
            double q = cosTheta * cosTheta - sin2;
            double milieu = F * (Math.tan(theta + alpha) + Math.tan(theta - alpha)) / 2;
            Vecteur vers = new Vecteur(c[0], c[1], 0).normalized();
            Vecteur cote = new Vecteur(-vers.y, vers.x, 0);
            Point centre = new Point().add(vers.mul(milieu));
            double radial = F * Math.sqrt(sin2 * (1 - sin2)) / q;
            double travers = F * Math.sqrt(sin2 / q);
            assertEquals(radial, bord(sphere, centre, vers), 1e-11);
            assertEquals(radial, bord(sphere, centre, vers.neg()), 1e-11);
            assertEquals(travers, bord(sphere, centre, cote), 1e-11);
            assertEquals(travers, bord(sphere, centre, cote.neg()), 1e-11);
        }
    }

    /** De combien avancer sur l'écran depuis ce point pour ne plus voir la sphère, par dichotomie. */
    private static double bord(Sphere sphere, Point depuis, Vecteur vers) {
        double dedans = 0;
        double dehors = 3;
        for (int k = 0; k < 60; k++) {
            double x = (dedans + dehors) / 2;
            Point ecran = depuis.add(vers.mul(x));
            if (sphere.getIntersectionDistance(new Rayon(ecran, new Vecteur(Camera.OEIL, ecran))) < Constantes.INFINI) {
                dedans = x;
            } else {
                dehors = x;
            }
        }
        return dedans;
    }

    /** Regardé de la lampe, le point juste en face renvoie Kd + Ks, quel que soit le poli. */
    @Test
    void lePointSousLaLampeRendKdPlusKsQuelQueSoitLePoli() {
        Random hasard = new Random(17);
        for (int k = 0; k < 1_000; k++) {
            double ns = new double[] {0, 1, 7.5, 40, 1000}[k % 5];
            Sphere boule = boule(2 * hasard.nextGaussian(), hasard.nextGaussian(), 5 + hasard.nextDouble(), 0.5, 0.4, 0.35, ns);
            Scene scene = scene(Collections.singletonList(boule), A_L_OEIL);
            assertEquals(0.75, scene.getCouleurVue(new Rayon(Camera.OEIL, boule.getCentre()), null, 0).r, 1e-12, "graine 17, tirage " + k);
        }
        Scene poli = scene(Collections.singletonList(boule(0, 0, 5, 1, 0.4, 0.35, 1e9)), A_L_OEIL);
        // à cette puissance, les quelques u de trois vecteurs normalisés se voient
        assertEquals(0.75, poli.getCouleurVue(new Rayon(Camera.OEIL, new Point()), null, 0).r, 0.35 * 1e9 * 8 * 0x1p-53);
    }

    /** Deux miroirs de Ks inégaux, 2m contacts : (c₁ + K₁c₂)(1 − (K₁K₂)^m)/(1 − K₁K₂). Compter une réflexion de trop se voit. */
    @Test
    void deuxMiroirsInegauxDonnentUneSuiteDeRaisonK1K2() {
        Sphere fond = boule(0, 0, 5, 1, 0.5, 0.75, 1);
        Sphere face = boule(0, 0, -7, 3, 0.2, 0.5, 1);
        Scene scene = scene(Arrays.asList(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1)));
        double c1 = (0.5 + 0.75) * 0.8;
        double c2 = (0.2 + 0.5) * 0.8;
        double raison = 0.75 * 0.5;
        for (int m : new int[] {1, 2, 3, 10, 30}) {
            double attendu = (c1 + 0.75 * c2) * (1 - Math.pow(raison, m)) / (1 - raison);
            Rayon devant = new Rayon(new Point(), new Vecteur(0, 0, 1));
            assertEquals(attendu, scene.getCouleurVue(devant, null, 2 * m - 1).r, 1e-12, m + " allers et retours");
        }
    }
}
