package lancer.promesses;

import static lancer.essai.Ressources.scene;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;

/** Ce qui est vrai de tous les vecteurs et de toutes les scènes : tirages à graine fixe. */
class ProprietesTest {

    private static final int TIRAGES = 20_000;

    /** Précision relative de la double précision. */
    private static final double U = 0x1p-53;

    private final Random hasard = new Random(20261121);

    private double signe() {
        return 2 * hasard.nextDouble() - 1;
    }

    private Vecteur vecteur(double echelle) {
        return new Vecteur(signe() * echelle, signe() * echelle, signe() * echelle);
    }

    private Point point(double echelle) {
        return new Point(signe() * echelle, signe() * echelle, signe() * echelle);
    }

    @Test
    void unVecteurNormaliseEstDeLongueurUnAQuatreUnitesPresQuelleQueSoitSaTaille() {
        for (int k = 0; k < TIRAGES; k++) {
            double echelle = Math.pow(10, 600 * hasard.nextDouble() - 300);
            Vecteur n = vecteur(echelle).normalized();
            // la norme est elle-même calculée à 2u près
            assertEquals(1, Math.sqrt(n.x * n.x + n.y * n.y + n.z * n.z), 6 * U, "tirage " + k + ", échelle " + echelle);
        }
        assertEquals(new Vecteur(1, 0, 0), new Vecteur(Double.MIN_VALUE, 0, 0).normalized());
        assertEquals(1, new Vecteur(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE).normalized().norme(), 4 * U);
        assertEquals(1, new Vecteur(Double.MIN_VALUE, -Double.MIN_VALUE, 0).normalized().norme(), 4 * U);
    }

    @Test
    void unVecteurPresqueUnitaireSeNormaliseSansRacineAussiJusteQueLesAutres() {
        for (int k = 0; k < TIRAGES; k++) {
            double ecart = Math.pow(10, -6 - 10 * hasard.nextDouble()) * (k % 2 == 0 ? 1 : -1);
            Vecteur v = vecteur(1).normalized().mul(1 + ecart);
            Vecteur n = v.normalized();
            double norme = Math.sqrt(v.norme2());
            String tirage = "tirage " + k + ", écart " + ecart;
            assertEquals(1, Math.sqrt(n.x * n.x + n.y * n.y + n.z * n.z), 6 * U, tirage);
            assertEquals(v.x / norme, n.x, 4 * U, tirage);
        }
    }

    @Test
    void laNormeEstJusteLaOuSonCarreNeLEstPas() {
        assertEquals(5e-200, new Vecteur(0, 3e-200, 4e-200).norme(), 1e-214);
        assertEquals(5e200, new Vecteur(0, 3e200, 4e200).norme(), 1e186);
        assertEquals(0, new Vecteur().norme());
        assertEquals(Double.POSITIVE_INFINITY, new Vecteur(0, Double.NEGATIVE_INFINITY, 0).norme());
        assertTrue(Double.isNaN(new Vecteur(0, Double.NaN, 0).norme()));
    }

    @Test
    void laNormaleEstUnitaireMemePourUneSpherePlusPetiteQueSesCoordonnees() {
        for (int k = 0; k < TIRAGES; k++) {
            Point c = point(1e6);
            double r = Math.pow(10, -100 * hasard.nextDouble());
            assertEquals(1, new Sphere(c, r).getNormale(c.add(vecteur(r))).norme(), 8 * U, "tirage " + k);
        }
    }

    @Test
    void uneSceneExtremeNAQueDesCouleursFinies() {
        for (int k = 0; k < 300; k++) {
            Sphere[] boules = new Sphere[6];
            for (int b = 0; b < boules.length; b++) {
                double echelle = Math.pow(10, 200 * hasard.nextDouble() - 100);
                boules[b] = new Sphere(new Point(signe() * echelle, signe() * echelle, hasard.nextDouble() * echelle),
                        Math.pow(10, 200 * hasard.nextDouble() - 100));
                boules[b].setKd(new Couleur(1));
                boules[b].setKs(new Couleur(1));
                boules[b].setNs(hasard.nextInt(3) * 0.7e9);
            }
            // une boule minuscule dans l'axe même du rayon, où le contact se confond avec le centre
            boules[0] = new Sphere(new Point(0, 0, 1 + hasard.nextInt(5)), 1e-100);
            boules[0].setKs(new Couleur(1));
            Scene scene = new Scene(List.of(boules),
                    List.of(new Lampe(point(Math.pow(10, 200 * hasard.nextDouble() - 100)), new Couleur(1e6)),
                            new Lampe(boules[1].getCentre(), new Couleur(1e6))));
            Ressources.Image image = new Ressources.Image(9, 9);
            new Lancer(scene, new Camera(9, 9)).TracerImage(image, 20, 1);
            assertTrue(image.estFinie(), "tirage " + k);
        }
    }
}
