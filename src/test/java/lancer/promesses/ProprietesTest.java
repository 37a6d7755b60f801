package lancer.promesses;

import static lancer.essai.Ressources.scene;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Ressources;
import lancer.essai.Tirages;
import lancer.rapide.Structuree;
import org.junit.jupiter.api.Test;

/** Ce qui est vrai de tous les vecteurs, rayons, sphères et scènes : tirages à graine fixe. */
class ProprietesTest {

    private static final int TIRAGES = 20_000;
    private static final int RAYONS = 100_000;
    private static final int PAR_SCENE = 1_000;
    private static final Camera CAMERA = new Camera(50, 40);

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
            Sphere sphere = new Sphere(c, r);
            assertEquals(1, sphere.getNormale(c.add(vecteur(r))).norme(), 8 * U, "tirage " + k);
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
            assertEquals(0, image.ecart(image), "tirage " + k);
        }
    }

    private static Vecteur reflechi(Vecteur V, Vecteur N) {
        return V.sub(N.mul(2 * V.dot(N))).normalized();
    }

    /** Kd, Ks ≤ 1, aucune lampe : au bout des miroirs il n'y a que le ciel, et chaque miroir n'en rend qu'une part. */
    @Test
    void sansLampeOnNeVoitJamaisPlusBrillantQueLeCielAuBoutDesMiroirs() {
        Tirages tirages = new Tirages(44);
        int auCiel = 0;
        for (int n = 0; n < RAYONS; n += PAR_SCENE) {
            Scene scene = Structuree.scene(scene(tirages.boules(2 + tirages.hasard.nextInt(20))), CAMERA);
            for (int k = 0; k < PAR_SCENE; k++) {
                Rayon premier = new Rayon(tirages.point(), tirages.direction());
                Couleur vue = scene.getCouleurVue(Rayon.unitaire(premier.getP(), premier.getV()), null, 12);
                Couleur part = new Couleur(1);
                Rayon rayon = premier;
                PointContact contact = scene.getClosestIntersection(rayon);
                for (int reflets = 0; contact != null && reflets < 12; reflets++) {
                    part = part.mul(contact.objet.getKs());
                    rayon = Rayon.reflechi(contact, reflechi(rayon.getV(), contact.objet.getNormale(contact)), part);
                    contact = scene.getClosestIntersection(rayon, contact.objet);
                }
                Couleur ciel = contact == null ? rayon.getSkyColor() : new Couleur();
                String cas = "graine 44, rayon " + (n + k) + " : " + vue + ", ciel " + ciel;
                assertTrue(vue.r <= ciel.r && vue.v <= ciel.v && vue.b <= ciel.b, cas);
                // et exactement cette part, à l'ordre des produits près
                assertEquals(part.r * ciel.r, vue.r, 1e-12, cas);
                assertEquals(part.v * ciel.v, vue.v, 1e-12, cas);
                assertEquals(part.b * ciel.b, vue.b, 1e-12, cas);
                auCiel += rayon != premier && contact == null ? 1 : 0;
            }
        }
        assertTrue(auCiel > RAYONS / 10, auCiel + " rayons réfléchis jusqu'au ciel");
    }

    /** Un nombre qui s'écrit avec peu de bits : la somme de deux d'entre eux ne s'arrondit pas. */
    private static double court(double x) {
        return Math.rint(x * 0x1p20) / 0x1p20;
    }

    @Test
    void deplacerEnsembleSphereEtRayonSansArrondiNeChangePasUnBit() {
        Tirages tirages = new Tirages(46);
        int touches = 0;
        for (int k = 0; k < RAYONS; k++) {
            Point p = new Point(court(tirages.entre(-4, 4)), court(tirages.entre(-4, 4)), court(tirages.entre(-4, 4)));
            Point c = new Point(court(tirages.entre(-4, 4)), court(tirages.entre(-4, 4)), court(tirages.entre(-4, 4)));
            Vecteur saut = new Vecteur(court(tirages.entre(-1e6, 1e6)), court(tirages.entre(-1e6, 1e6)), court(tirages.entre(-1e6, 1e6)));
            double r = tirages.entre(0.1, 2);
            Vecteur v = new Vecteur(p, c).add(tirages.direction().mul(1.2 * r)).normalized();
            double t = new Sphere(c, r).getIntersectionDistance(new Rayon(p, v));
            assertEquals(t, new Sphere(c.add(saut), r).getIntersectionDistance(new Rayon(p.add(saut), v)), "graine 46, tirage " + k);
            touches += t < Constantes.INFINI ? 1 : 0;
        }
        assertTrue(touches > RAYONS / 4, touches + " touchés");
    }
}
