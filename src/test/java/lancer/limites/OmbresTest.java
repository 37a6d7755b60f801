package lancer.limites;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.scene;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Ombre;
import org.junit.jupiter.api.Test;

/** Les ombres là où un arrondi en ferait ou en ôterait : sols immenses, lampes lointaines, sphères qui se touchent. */
class OmbresTest {

    @Test
    void deDeuxSpheresQuiSInterpenetrentCelleQuiEntoureLeDepartCompte() {
        Sphere a = boule(-0.5, 0, 6, 1, 1, 0, 1);
        Sphere b = boule(0.5, 0, 6, 1, 1, 0, 1);
        Scene scene = scene(Arrays.asList(a, b));
        // sur a, et au centre de b
        Point depart = new Point(0.5, 0, 6);
        for (Vecteur v : new Vecteur[] {new Vecteur(1, 0, 0), new Vecteur(0, 0, -1), new Vecteur(0, 0.6, 0.8)}) {
            PointContact sortie = scene.getClosestIntersection(new Rayon(depart, v), a);
            assertSame(b, sortie.objet);
            assertEquals(1, sortie.distance, 1e-15);
        }
        Lampe dehors = new Lampe(new Point(0.5, 9, 6), new Couleur(1));
        assertTrue(Ombre.cachee(scene, dehors, depart, a), "b entoure le contact");
        assertFalse(Ombre.cachee(scene, dehors, new Point(0.5, 1, 6), b), "le haut de b est libre");
    }

    /**
     * Une boule posée sur le sol, une lampe droit au-dessus : son ombre est un disque noir. Près du pied le rayon voit le sol ou
     * le dessous de la boule, à quelques dix-millionièmes près ; l'un et l'autre sont noirs.
     */
    @Test
    void lePiedDUneBoulePoseeSurLeSolEstExactementNoir() {
        for (double R : new double[] {100, 1e4, 1e6}) {
            List<Sphere> boules = Arrays.asList(boule(0, -R, 10, R, 1, 0, 1), boule(0, 1, 10, 1, 1, 0.5, 9));
            Scene scene = scene(boules, new Lampe(new Point(0, 50, 10), new Couleur(1)));
            Point oeil = new Point(0, 3, 0);
            // la lampe est à 49 du centre : le cône d'ombre a 50·tan(asin(1/49)) = 1,0206 au sol, si celui-ci est plat
            for (double d = 1e-9; d < 0.9; d *= 1.07) {
                for (double phi = 0; phi < 3.2; phi += 0.4) {
                    Point vise = new Point(d * Math.cos(phi), 0, 10 - d * Math.sin(phi));
                    assertEquals(new Couleur(), scene.getCouleurVue(new Rayon(oeil, vise), null, 0), "R = " + R + ", d = " + d);
                }
            }
            for (double d = 1.2; d < 3; d += 0.1) {
                assertTrue(scene.getCouleurVue(new Rayon(oeil, new Point(0, 0, 10 - d)), null, 0).r > 0.8, "R = " + R + ", d = " + d);
            }
        }
    }

    /** Le contact n'est connu qu'à 4 u (r + |C|) près : à deux fois cela, deux coquilles se distinguent ; à un huitième, non. */
    @Test
    void deDeuxCoquillesAHuitArrondisCelleDuDehorsEstVueEtEclairee() {
        assertEquals(0, confondues(8));
        assertTrue(confondues(0.5) > 100, confondues(0.5) + " pixels : un double ne peut les distinguer");
    }

    /** @param ecart de deux boules concentriques, en u (r + |C|) ; le nombre de pixels où celle du dehors n'est pas vue, ou ombrée */
    private static int confondues(double ecart) {
        Random hasard = new Random(52);
        Camera camera = new Camera(60, 60);
        Lampe lampe = new Lampe(new Point(3, 5, -4), new Couleur(1));
        int confondues = 0;
        for (int essai = 0; essai < 20; essai++) {
            Point C = new Point(0.3 * hasard.nextGaussian(), 0.3 * hasard.nextGaussian(), 4 + 4 * hasard.nextDouble());
            double r = 0.5 + hasard.nextDouble();
            double jeu = ecart * 0x1p-53 * (r + new Vecteur(new Point(), C).norme());
            Sphere dehors = boule(C.x, C.y, C.z, r, 1, 0, 1);
            Scene scene = scene(Arrays.asList(boule(C.x, C.y, C.z, r - jeu, 1, 0, 1), dehors), lampe);
            for (int k = 0; k < 60 * 60; k++) {
                PointContact vu = scene.getClosestIntersection(camera.getRayon(k % 60 + 0.5, k / 60 + 0.5));
                confondues += vu != null && (vu.objet != dehors || dehors.getNormale(vu).dot(new Vecteur(vu, lampe.getPosition())) > 0
                        && Ombre.cachee(scene, lampe, vu, dehors)) ? 1 : 0;
            }
        }
        return confondues;
    }
}
