package lancer;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.image;
import static lancer.essai.Ressources.memesBits;
import static lancer.essai.Ressources.scene;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.essai.Ombre;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;

/** Des scènes dont la théorie donne l'image, et les régimes où une méthode moins sûre se trompe. */
class TheorieTest {

    private static final Lampe A_L_OEIL = new Lampe(Camera.OEIL, new Couleur(1));
    private static final Rayon DEVANT = new Rayon(new Point(), new Vecteur(0, 0, 1));

    /** cos(N, V) au contact d'une sphère centrée sur l'axe à la distance D de l'œil : √(1 − (D/r)² sin²ψ). */
    private static double cosinus(Rayon rayon, double D, double r) {
        double sin2 = 1 - rayon.getV().z * rayon.getV().z;
        return Math.sqrt(1 - D * D / (r * r) * sin2);
    }

    @Test
    void uneLampeALOeilEclaireToutCeQuiSeVoitSelonLambertEtPhong() {
        double D = 5 + Camera.FOCALE;
        Scene scene = scene(Collections.singletonList(boule(0, 0, 5, 1, 0.7, 0.3, 8)), A_L_OEIL);
        Camera camera = new Camera(101, 101);
        Lancer lancer = new Lancer(scene, camera);
        int touches = 0;
        for (int j = 0; j < 101; j++) {
            for (int i = 0; i < 101; i++) {
                Rayon rayon = camera.getRayon(i + 0.5, j + 0.5);
                if (scene.getClosestIntersection(rayon) != null) {
                    double c = cosinus(rayon, D, 1);
                    double attendu = 0.7 * c + 0.3 * Math.pow(Math.max(0, 2 * c * c - 1), 8);
                    assertEquals(attendu, lancer.getCouleurPixel(i + 0.5, j + 0.5, 0).r, 1e-9, "pixel " + i + ", " + j);
                    touches++;
                }
            }
        }
        assertTrue(touches > 1000);
    }

    @Test
    void laSilhouetteDUneSphereEstUneEllipseDAireConnue() {
        double D = Math.hypot(1, 5 + Camera.FOCALE);
        double sin2 = 1 / (D * D);
        double cos2Theta = 1 - 1 / (D * D);
        double F = Camera.FOCALE;
        double aire = Math.PI * F * F * sin2 * Math.sqrt(1 - sin2) / Math.pow(cos2Theta - sin2, 1.5) * 200 * 200;
        Ressources.Image image = image(scene(Collections.singletonList(boule(1, 0, 5, 1, 0, 0, 1))), 400, 300, 0, 2);
        int noirs = 0;
        for (int k = 0; k < image.composantes.length; k += 3) {
            noirs += image.composantes[k + 2] == 0 ? 1 : 0;
        }
        assertEquals(aire, noirs, Math.pow(aire / Math.PI, 1.0 / 3));
    }

    @Test
    void deuxMiroirsFaceAFaceDonnentUneSuiteGeometrique() {
        // contacts en z = ±4 sur l'axe, lampe en (0, 3, 0) : N·L = R·L = 4/5
        Sphere fond = boule(0, 0, 5, 1, 0.5, 0.5, 1);
        Sphere face = boule(0, 0, -5, 1, 0.5, 0.5, 1);
        Scene scene = scene(Arrays.asList(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1)));
        double c = 0.5 * 0.8 + 0.5 * 0.8;
        for (int n : new int[] {0, 1, 5, 20}) {
            double attendu = c * (1 - Math.pow(0.5, n + 1)) / (1 - 0.5);
            assertEquals(attendu, scene.getCouleurVue(DEVANT, null, n).r, 1e-12, n + " réflexions");
        }
    }

    @Test
    void leSeuilNOublieQueCeQuIlPromet() {
        Sphere fond = boule(0, 0, 5, 1, 0.5, 0.5, 1);
        Sphere face = boule(0, 0, -5, 1, 0.5, 0.5, 1);
        Scene scene = scene(Arrays.asList(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1)));
        double limite = 2 * 0.8;
        for (double seuil : new double[] {0.5, 0.1, 1.0 / 1024, 1e-9}) {
            scene.getModele().setSeuil(seuil);
            double oubli = limite - scene.getCouleurVue(DEVANT, null, 1000).r;
            assertTrue(oubli > 0 && oubli <= seuil * limite, "seuil " + seuil + ", oubli " + oubli);
        }
    }

    @Test
    void leSeuilPorteSurLaPlusGrandeComposanteDuProduitDesKs() {
        Sphere fond = boule(0, 0, 5, 1, 0.01, 0, 1);
        Sphere face = boule(0, 0, -5, 1, 0.01, 0, 1);
        fond.setKs(new Couleur(1, 0.1, 0));
        face.setKs(new Couleur(1, 0, 0.1));
        Scene scene = scene(Arrays.asList(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1)));
        scene.getModele().setSeuil(1);
        scene.getCouleurVue(DEVANT, null, 40);
        assertEquals(40, scene.getCompteurs().reflechis, "le rouge continue");
        // égal au seuil : encore suivi
        fond.setKs(new Couleur(0.5));
        face.setKs(new Couleur(0.5));
        Scene demi = scene(Arrays.asList(fond, face), scene.getLampes().get(0));
        demi.getModele().setSeuil(0.125);
        demi.getCouleurVue(DEVANT, null, 40);
        assertEquals(3, demi.getCompteurs().reflechis);
    }

    @Test
    void milleReflexionsSansPerteNiDebordementDePile() {
        Sphere fond = boule(0, 0, 5, 1, 0.5, 1, 1);
        Sphere face = boule(0, 0, -5, 1, 0.5, 1, 1);
        Scene scene = scene(Arrays.asList(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1)));
        double c = 0.5 * 0.8 + 0.8;
        assertEquals(1001 * c, scene.getCouleurVue(DEVANT, null, 1000).r, 1e-9);
    }

    @Test
    void unMiroirSeulMontreLeCielDansLaDirectionReflechie() {
        Scene scene = scene(Collections.singletonList(boule(0.2, -0.1, 5, 1, 0, 0.8, 1)));
        Camera camera = new Camera(60, 40);
        int touches = 0;
        for (int j = 0; j < 40; j++) {
            for (int i = 0; i < 60; i++) {
                Rayon rayon = camera.getRayon(i + 0.5, j + 0.5);
                PointContact contact = scene.getClosestIntersection(rayon);
                if (contact != null) {
                    Vecteur N = contact.objet.getNormale(contact);
                    Rayon reflechi = new Rayon(contact, rayon.getV().sub(N.mul(2 * N.dot(rayon.getV()))));
                    if (Math.abs(reflechi.getV().y) > 1e-9) {
                        assertEquals(0.8 * reflechi.getSkyColor().r, scene.getCouleurVue(rayon, null, 1).r, 1e-9);
                        touches++;
                    }
                }
            }
        }
        assertTrue(touches > 100);
    }

    @Test
    void unObjetAuDelaDeLaLampeNOmbrePas() {
        Sphere boule = boule(0, 0, 5, 1, 1, 0, 1);
        Lampe lampe = new Lampe(new Point(0, 0, 0), new Couleur(1));
        Scene seule = scene(Collections.singletonList(boule), lampe);
        Scene avec = scene(Arrays.asList(boule, boule(0, 0, -20, 1, 0, 0, 1)), lampe);
        assertTrue(memesBits(image(seule, 40, 30, 0, 1), image(avec, 40, 30, 0, 1)));
    }

    @Test
    void uneLampeDansUneSphereNEclaireRienAuDehors() {
        Scene scene = scene(Arrays.asList(boule(0, 0, 8, 1, 1, 0, 1), boule(0, 0, 4, 0.5, 1, 1, 9)),
                new Lampe(new Point(0.1, 0, 4), new Couleur(9)));
        assertEquals(new Couleur(), scene.getCouleurVue(DEVANT, null, 0));
        assertEquals(new Couleur(), scene.getCouleurVue(new Camera(800, 600).getRayon(440, 300), null, 0));
    }

    @Test
    void uneLampeSurUneSurfaceNEclairePasCetteSphereEtNeDonneJamaisNaN() {
        Sphere boule = boule(0, 0, 5, 1, 1, 0.5, 3);
        Lampe utile = new Lampe(new Point(3, 4, 0), new Couleur(0.5));
        Ressources.Image sans = image(scene(Collections.singletonList(boule), utile), 41, 31, 5, 1);
        Ressources.Image avec = image(scene(Collections.singletonList(boule),
                new Lampe(new Point(0, 0, 4), new Couleur(1)), utile), 41, 31, 5, 1);
        assertTrue(memesBits(sans, avec));
    }

    @Test
    void deLInterieurDUneSphereOnVoitSaParoiEclaireeDuDehors() {
        // l'écran est dans la sphère ; la lampe, au-delà de la sortie, voit la normale extérieure
        Scene scene = scene(Collections.singletonList(boule(0, 0, 0, 3, 0.6, 0, 1)), new Lampe(new Point(0, 4, 3), new Couleur(1)));
        assertEquals(0, scene.getCouleurVue(DEVANT, null, 0).r, 0, "N·L = 0 : juste au bord");
        Scene haut = scene(Collections.singletonList(boule(0, 0, 0, 3, 0.6, 0, 1)), new Lampe(new Point(0, 4, 6), new Couleur(1)));
        assertEquals(0.6 * 0.6, haut.getCouleurVue(DEVANT, null, 0).r, 1e-12);
    }

    @Test
    void unSolImmenseVuALaLampeNAPasDePointsNoirs() {
        for (double r : new double[] {1e4, 1e6, 1e8}) {
            Ressources.Image image = image(scene(Collections.singletonList(boule(0, -r - 1, 5, r, 0.8, 0, 1)), A_L_OEIL), 60, 40, 0, 1);
            for (int k = 2; k < image.composantes.length; k += 3) {
                assertTrue(image.composantes[k] > 0, "rayon " + r + ", pixel " + k / 3);
            }
        }
    }

    @Test
    void uneLampeTresLointaineFaitUneOmbreCylindrique() {
        // le soleil à 1e9 au-dessus d'une boule de rayon 1 posée loin d'un sol presque plat
        double r = 1e4;
        Sphere sol = boule(0, -r - 2, 20, r, 1, 0, 1);
        Scene scene = scene(Arrays.asList(sol, boule(0, 0, 20, 1, 0, 0, 1)), new Lampe(new Point(0, 1e9, 20), new Couleur(1)));
        for (double x = -1.995; x < 2; x += 0.01) {
            double y = -r - 2 + Math.sqrt(r * r - x * x);
            Point contact = new Point(x, y, 20);
            assertEquals(Math.abs(x) < 1, Ombre.cachee(scene, scene.getLampes().get(0), contact, sol), "x = " + x);
        }
    }

    @Test
    void unPoliNulDonneUnRefletEntierSurToutLeCoteEclaire() {
        Sphere boule = boule(0, 0, 5, 1, 0, 0.5, 0);
        Scene cote = scene(Collections.singletonList(boule), new Lampe(new Point(50, 0, 3), new Couleur(1)));
        assertEquals(0.5, cote.getCouleurVue(DEVANT, null, 0).r, 0, "R·L < 0, mais 0^0 = 1");
        Scene dos = scene(Collections.singletonList(boule), new Lampe(new Point(0, 0, 50), new Couleur(1)));
        assertEquals(new Couleur(), dos.getCouleurVue(DEVANT, null, 0));
    }

    @Test
    void aucunRefletDeLampeNeDepasseSonKs() {
        Sphere boule = boule(0, 0, 5, 1, 0, 0.5, 1e9);
        for (int k = 1; k < 2000; k++) {
            Rayon rayon = new Camera(4000, 10).getRayon(2000 + 0.01 * k, 5);
            Scene muette = scene(Collections.singletonList(boule));
            PointContact contact = muette.getClosestIntersection(rayon);
            Vecteur N = boule.getNormale(contact);
            Vecteur R = rayon.getV().sub(N.mul(2 * N.dot(rayon.getV()))).normalized();
            Scene scene = scene(Collections.singletonList(boule), new Lampe(contact.add(R.mul(7)), new Couleur(1)));
            assertTrue(boule.getColor(scene, rayon, contact, 0).r <= 0.5);
        }
    }

    @Test
    void uneRangeeEntiereALHorizonALaSecondeCouleurDuCiel() {
        Ressources.Image image = image(scene(Collections.<Objet3D>emptyList()), 3, 3, 5, 1);
        for (int i = 0; i < 3; i++) {
            assertEquals((float) DEVANT.getSkyColor().v, image.composantes[3 * (3 + i) + 1]);
            assertEquals((float) new Camera(3, 3).getRayon(i + 0.5, 0.5).getSkyColor().b, image.composantes[3 * i + 2]);
        }
    }

    @Test
    void unRayonQuiNePeutRienChangerNEstPasLance() {
        Lampe lampe = new Lampe(new Point(0, 0, -9), new Couleur(1));
        Scene mate = scene(Collections.singletonList(boule(0, 0, 5, 1, 1, 0, 1)), lampe);
        mate.getCouleurVue(DEVANT, null, 5);
        assertEquals(1, mate.getCompteurs().ombre);
        assertEquals(0, mate.getCompteurs().reflechis, "Ks = 0");
        Scene noire = scene(Collections.singletonList(boule(0, 0, 5, 1, 0, 0, 1)), lampe);
        noire.getCouleurVue(DEVANT, null, 5);
        assertEquals(0, noire.getCompteurs().ombre, "ni Kd ni Ks");
        Scene dos = scene(Collections.singletonList(boule(0, 0, 5, 1, 1, 0, 1)), new Lampe(new Point(0, 0, 9), new Couleur(1)));
        dos.getCouleurVue(DEVANT, null, 5);
        assertEquals(0, dos.getCompteurs().ombre, "N·L ≤ 0");
    }

    @Test
    void desPetitesBoulesSeRefletentSansDeriveDesLongueurs() {
        // le piège des normales non ramenées à 1 : des boules de rayon 0,03 à une distance de 6
        List<Sphere> boules = new ArrayList<>();
        for (int k = 0; k < 400; k++) {
            boules.add(boule(0.08 * (k % 20) - 0.8, 0.08 * (k / 20) - 0.8, 6 + 0.05 * (k % 3), 0.03, 0.3, 0.6, 30));
        }
        Scene scene = scene(boules, new Lampe(new Point(3, 5, -2), new Couleur(1)));
        Ressources.Image image = image(scene, 160, 120, 12, 2);
        for (float c : image.composantes) {
            assertFalse(c < 0 || c > 2.5 || Float.isNaN(c), "couleur " + c);
        }
    }
}
