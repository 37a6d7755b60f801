package lancer.antialias;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PartageTest {

    private static final Pave PAVE = new Pave(32, 64, 64, 96);
    private static final Toile SANS_TOILE = (couleur, i, j) -> { };

    /** Les pixels d'un pavé, ligne par ligne. */
    private static Couleur[] pixels(Echantillonnage echantillonnage, Pave pave, Vue vue) {
        int largeur = pave.i1 - pave.i0;
        Couleur[] pixels = new Couleur[largeur * (pave.j1 - pave.j0)];
        echantillonnage.tracer(pave, pave, vue, (couleur, i, j) -> {
            int k = (j - pave.j0) * largeur + i - pave.i0;
            assertEquals(null, pixels[k], "chaque pixel une seule fois");
            pixels[k] = couleur;
        });
        return pixels;
    }

    /** Vrai au-dessus d'une droite oblique : un bord net, blanc sur noir. */
    private static double bord(double xe, double ye) {
        return 0.31 * (xe - 48) + (ye - 80) > 0.2 ? 1 : 0;
    }

    @Test
    void aSeuilNulLImageEstCelleDuCoursAuBitPres() {
        Vue vue = (xe, ye) -> new Couleur(Math.sin(xe * xe), bord(xe, ye), Math.cos(7 * ye));
        for (int n : new int[] {1, 2, 3, 8}) {
            assertEquals(List.of(pixels(new Coins(n, 0), PAVE, vue)), List.of(pixels(Antialias.partage(n, 0), PAVE, vue)));
            assertEquals(new Coins(n, 0).tracer(PAVE, PAVE, vue, SANS_TOILE).raffines,
                    Antialias.partage(n, 0).tracer(PAVE, PAVE, vue, SANS_TOILE).raffines, "raffinés");
        }
    }

    /** Chaque rayon passe par le centre d'un sous-pixel du pavé, et aucun n'est lancé deux fois. */
    @ParameterizedTest
    @CsvSource({"2, 0.01", "3, 0.01", "3, 0.1", "5, 0.02", "8, 0.06", "16, 0.06"})
    void unSousPixelNEstVuQuUneFoisEtEnSonCentre(int n, double seuil) {
        for (Pave pave : new Pave[] {PAVE, new Pave(0, 0, 1, 1), new Pave(0, 0, 1, 5), new Pave(0, 0, 32, 1), new Pave(0, 0, 2, 2)}) {
            Set<Long> vus = new HashSet<>();
            pixels(new Partage(n, seuil), pave, (xe, ye) -> {
                long x = Math.round(xe * n - 0.5);
                long y = Math.round(ye * n - 0.5);
                assertEquals((double) (x - pave.i0 * n), (xe - pave.i0) * n - 0.5, 1e-9);
                assertEquals((double) (y - pave.j0 * n), (ye - pave.j0) * n - 0.5, 1e-9);
                assertTrue(x >= pave.i0 * n && x < pave.i1 * n && y >= pave.j0 * n && y < pave.j1 * n, "hors du pavé");
                assertTrue(vus.add(x << 32 | y), "vu deux fois");
                return new Couleur(bord(xe, ye));
            });
            assertTrue(vus.size() <= n * n * (pave.i1 - pave.i0) * (pave.j1 - pave.j0));
        }
    }

    @Test
    void unPaveUniformeNeCouteQueSaTrame() {
        int[] rayons = new int[1];
        Couleur gris = new Couleur(0.25, 0.5, 3);
        Vue vue = (xe, ye) -> {
            rayons[0]++;
            return gris;
        };
        for (Couleur pixel : pixels(new Partage(8, 0.06), PAVE, vue)) {
            assertEquals(0.25, pixel.r, 1e-15);
            assertEquals(0.5, pixel.v, 1e-15);
            assertEquals(3, pixel.b, 1e-14, "non limitée");
        }
        assertEquals(33 * 33 + 512, rayons[0], "et le milieu d'une case sur deux");
    }

    /** Là où la couleur est une fonction affine de la position, l'interpolation ne perd rien. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 7, 8, 16})
    void unDegradeEstRenduExactement(int n) {
        Vue vue = (xe, ye) -> new Couleur(0.01 * xe, 0.5 - 0.003 * ye, 0.2 + 0.001 * (xe - 2 * ye));
        Couleur[] complet = pixels(new Coins(n, 0), PAVE, vue);
        for (double seuil : new double[] {0.02, 0.055, 0.1, 2}) {
            Couleur[] partage = pixels(new Partage(n, seuil), PAVE, vue);
            for (int k = 0; k < complet.length; k++) {
                assertEquals(complet[k].r, partage[k].r, 1e-14);
                assertEquals(complet[k].v, partage[k].v, 1e-14);
                assertEquals(complet[k].b, partage[k].b, 1e-14);
            }
        }
    }

    /** Un bord droit ne coûte que les cases qu'il traverse : deux fois plus de finesse, environ deux fois plus de rayons. */
    @Test
    void unBordCouteDeLOrdreDeNEtNonDeNCarre() {
        double[] rayons = new double[2];
        for (int k = 0; k < 2; k++) {
            int rang = k;
            pixels(new Partage(k == 0 ? 16 : 32, 0.06), PAVE, (xe, ye) -> {
                rayons[rang]++;
                return new Couleur(bord(xe, ye));
            });
            rayons[k] -= 33 * 33 + 512;
        }
        assertTrue(rayons[1] < 2.3 * rayons[0], () -> Arrays.toString(rayons));
    }

    /** Ce que la mesure a montré, gardé sur une scène : moins de rayons, et moins d'erreur. */
    @Test
    void pourMoinsDeRayonsLErreurEstMoindreQueCelleDuCours() {
        Compteurs cours = new Compteurs();
        Compteurs partage = new Compteurs();
        double[] reference = image(new Coins(20, 0), new Compteurs());
        double erreurCours = rms(reference, image(new Coins(4, 0.05), cours));
        double erreurPartage = rms(reference, image(new Partage(8, 0.06), partage));
        assertTrue(partage.primaires < cours.primaires, () -> partage.primaires + " contre " + cours.primaires);
        assertTrue(erreurPartage < erreurCours, () -> erreurPartage + " contre " + erreurCours);
        assertTrue(partage.pixelsRaffines > 0);
    }

    /** Trois boules brillantes, limitées à [0, 1]. */
    private static double[] image(Echantillonnage echantillonnage, Compteurs compteurs) {
        Sphere[] boules = new Sphere[3];
        for (int k = 0; k < 3; k++) {
            boules[k] = new Sphere(new Point(k - 1, 0.4 * k - 0.3, 5 + k), 0.6);
            boules[k].setKd(new Couleur(0.8, 0.2 * k, 0.3));
            boules[k].setKs(new Couleur(0.4));
            boules[k].setNs(50);
        }
        Scene scene = new Scene(List.of(boules), List.of(new Lampe(new Point(-5, 6, -3), new Couleur(0.9))));
        double[] image = new double[60 * 45];
        Lancer lancer = new Lancer(scene.avec(scene.getModele().avec(echantillonnage, scene.getModele().getSeuil())), new Camera(60, 45));
        lancer.TracerImage((couleur, i, j) -> image[60 * j + i] = Math.min(1, couleur.r), 5, 2);
        compteurs.ajouter(lancer.getAtelier().getCompteurs());
        return image;
    }

    private static double rms(double[] a, double[] b) {
        double somme = 0;
        for (int k = 0; k < a.length; k++) {
            somme += (a[k] - b[k]) * (a[k] - b[k]);
        }
        return Math.sqrt(somme / a.length);
    }

    /** Des boules noires d'un même rayon, en pixels, au hasard sur un ciel ; le pixel central en est à 1 de l'écran à z = 0. */
    private static Scene poussiere(double rayon) {
        Camera camera = new Camera(L, H);
        Random hasard = new Random(5);
        List<Sphere> boules = new ArrayList<>();
        double loin = (8 + Camera.FOCALE) / Camera.FOCALE;
        for (int k = 0; k < 40; k++) {
            boules.add(new Sphere(new Point(camera.getX(camera.getLargeur() * hasard.nextDouble()) * loin,
                    camera.getY(camera.getHauteur() * hasard.nextDouble()) * loin, 8),
                    rayon * 2 / camera.getLargeur() * loin));
        }
        return new Scene(boules, List.of());
    }

    private static final int L = 64;
    private static final int H = 48;

    private static double[] rouges(Scene scene, Echantillonnage echantillonnage, long[] rayons) {
        double[] rouges = new double[L * H];
        Lancer traceur = new Lancer(scene.avec(scene.getModele().avec(echantillonnage, 0)), new Camera(L, H));
        traceur.TracerImage((couleur, i, j) -> rouges[L * j + i] = Math.min(1, couleur.r), 0, 2);
        rayons[0] = traceur.getAtelier().getCompteurs().primaires;
        return rouges;
    }

    /** Le remède : là où des boules plus petites qu'un pixel sont semées, quelques-unes, vues, font chercher les autres. */
    @ParameterizedTest
    @ValueSource(doubles = {0.4, 0.6})
    void desBoulesPlusPetitesQuUnPixelSontMieuxVuesQueParUneGrilleDeuxFoisPlusChere(double rayon) {
        Scene scene = poussiere(rayon);
        long[] rayons = new long[1];
        double[] juste = rouges(scene, new Coins(32, 0), rayons);
        double grille = rms(juste, rouges(scene, new Coins(5, 0), rayons));
        double partage = rms(juste, rouges(scene, new Partage(16, 0.055), rayons));
        assertTrue(partage < grille, () -> partage + " contre " + grille);
        assertTrue(rayons[0] < 12 * L * H, () -> (double) rayons[0] / (L * H) + " rayons par pixel");
    }

    @Test
    void unPixelDUnePoussiereADemandeSeulLesBitsDeLImageEntiere() {
        Scene scene = poussiere(0.3);
        Camera camera = new Camera(L, H);
        Echantillonnage partage = new Partage(8, 0.06);
        Scene prete = scene.avec(scene.getModele().avec(partage, 0));
        Couleur[] entiere = new Couleur[L * H];
        new Lancer(prete, camera).TracerImage((couleur, i, j) -> entiere[L * j + i] = couleur, 0, 2);
        Vue vue = (xe, ye) -> new Lancer(prete, camera).getCouleurPixel(xe, ye, 0);
        for (int k = 0; k < L * H; k += 37) {
            int i = k % L;
            int j = k / L;
            Pave pave = Pave.autour(i, j, L, H);
            partage.tracer(pave, new Pave(i, j, i + 1, j + 1), vue, (couleur, x, y) -> assertEquals(entiere[L * y + x], couleur));
        }
    }

    /**
     * Là où elle échoue : un détail seul. Il y a trois points pour deux pixels, dont les plus proches sont séparés de √2·⌊n/2⌋/n : un
     * disque de rayon ρ ≤ ⌊n/2⌋/(√2·n) est manqué avec la probabilité 1 − 3πρ²/2.
     */
    @ParameterizedTest
    @CsvSource({"8, 0.2", "8, 0.35", "3, 0.23"})
    void laProbabiliteDeManquerUnDisqueAUneFormeClose(int n, double rho) {
        Random hasard = new Random(39);
        Pave voisinage = new Pave(0, 0, 6, 6);
        int essais = 5_000;
        int manques = 0;
        for (int essai = 0; essai < essais; essai++) {
            double x = 2 + 2 * hasard.nextDouble();
            double y = 2 + 2 * hasard.nextDouble();
            boolean[] vu = new boolean[1];
            new Partage(n, 0.06).tracer(voisinage, voisinage, (xe, ye) -> {
                boolean dedans = (xe - x) * (xe - x) + (ye - y) * (ye - y) < rho * rho;
                vu[0] |= dedans;
                return new Couleur(dedans ? 1 : 1e-6 * xe);
            }, (couleur, i, j) -> { });
            manques += vu[0] ? 0 : 1;
        }
        double attendue = 1 - 1.5 * Math.PI * rho * rho;
        assertEquals(attendue, (double) manques / essais, 4 * Math.sqrt(attendue * (1 - attendue) / essais));
    }
}
