package lancer.mesures.stabilite;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.antialias.Antialias;
import lancer.contrat.Echantillonnage;
import lancer.dessin.Dessin;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;

/** Des sphères noires sur le ciel, de même rayon à l'écran, éloignées les unes des autres et placées au hasard. */
final class PetitesBoules {

    static final String FIGURE = "petites";
    static final String SANS = "partage_aveugle";

    /** Sous-pixels d'un côté, pour toutes les méthodes. */
    static final int N = 4;

    private static final int LARGEUR = 400;
    private static final int HAUTEUR = 300;
    private static final double[] RAYONS = {0.1, 0.14, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.4, 2};

    /** Côté, en pixels, de la case d'une sphère, et du carré où son centre est tiré uniformément. */
    private static final int CASE = 12;
    private static final int CARRE = 6;
    private static final double Z = 10;

    /** Nombre de points par côté du pixel dont la moyenne remplace celle du pixel. */
    private static final int FINESSE = 24;

    private final Camera camera = new Camera(LARGEUR, HAUTEUR);
    private final double rayon;
    private final List<Sphere> boules = new ArrayList<>();

    /** La somme des carrés de la couleur du ciel que cache chaque sphère, moyenne des trois composantes, en niveaux². */
    private double contraste;

    private PetitesBoules(double rayon, long graine) {
        this.rayon = rayon;
        Random hasard = new Random(graine);
        for (int j = 0; j + CASE <= HAUTEUR; j += CASE) {
            for (int i = 0; i + CASE <= LARGEUR; i += CASE) {
                poser(i + (CASE - CARRE) / 2 + CARRE * hasard.nextDouble(), j + (CASE - CARRE) / 2 + CARRE * hasard.nextDouble());
            }
        }
    }

    /** L'image d'une sphère de rayon r, à l'angle θ de l'axe, a l'aire d'un disque de rayon F r/(D cos^2,5 θ). */
    private void poser(double xe, double ye) {
        Rayon vers = camera.getRayon(xe, ye);
        double agrandissement = (Z + Camera.FOCALE) / Camera.FOCALE;
        double cosinus = vers.getV().z;
        double pixel = Constantes.ECHELLE / LARGEUR * agrandissement;
        boules.add(new Sphere(new Point(camera.getX(xe) * agrandissement, camera.getY(ye) * agrandissement, Z),
                rayon * pixel * Math.sqrt(cosinus)));
        Couleur ciel = vers.getSkyColor();
        contraste += 255 * 255 * (ciel.r * ciel.r + ciel.v * ciel.v + ciel.b * ciel.b) / 3;
    }

    /** L'erreur de chaque méthode pour chaque rayon, et l'erreur attendue, 0 si elle n'a pas de forme close. */
    static List<Exactitude> mesurer(boolean rapide) {
        Map<String, Echantillonnage> methodes = new LinkedHashMap<>();
        methodes.put("un_rayon", null);
        methodes.put("coins", Antialias.coins(N, 0.05));
        methodes.put(SANS, (pave, voulus, vue, toile) -> Antialias.partage(N, 0.1).tracer(pave, pave, vue, toile));
        methodes.put("partage", Antialias.partage(N, 0.1));
        methodes.put("grille", Antialias.coins(N, 0));
        List<Exactitude> exactitudes = new ArrayList<>();
        for (int k = 0; k < RAYONS.length; k += rapide ? 3 : 1) {
            PetitesBoules image = new PetitesBoules(RAYONS[k], k);
            Scene scene = new Scene(image.boules, Collections.emptyList());
            Gabarit gabarit = new Gabarit(scene, LARGEUR, HAUTEUR, 1);
            methodes.forEach((nom, methode) -> {
                Lancer lancer = Dessin.lancer(scene.avec(scene.getModele().avec(methode, 0)), LARGEUR, HAUTEUR, false);
                double erreur = Intervalle.deLaRacine(gabarit.carres(ImageLineaire.de(lancer, 0, 2))).valeur;
                exactitudes.add(new Exactitude(FIGURE, nom, image.rayon, erreur, image.boules.size(), 0, image.attendue(nom),
                        (double) lancer.getCompteurs().rayons() / LARGEUR / HAUTEUR));
            });
        }
        return exactitudes;
    }

    // ---- l'erreur attendue

    /**
     * Erreur attendue d'une méthode pour un disque au hasard. Son carré est la somme, sur toutes les paires de points pondérés, de l'aire
     * commune à deux disques centrés en ces points. Les points du pixel lui-même ont un poids négatif.
     */
    private double attendue(String methode) {
        int n = methode.equals("un_rayon") ? 1 : N;
        // « coins » ne voit que ses coins, si le disque est assez petit pour ne toucher qu'un sous-pixel
        boolean coins = methode.equals("coins");
        if (methode.startsWith("partage") || coins && rayon > 0.5 / N) {
            return 0;
        }
        List<double[]> points = new ArrayList<>();
        ajouter(points, n, 1, coins);
        ajouter(points, FINESSE, -1, false);
        double carre = 0;
        for (double[] p : points) {
            for (double[] q : points) {
                carre += p[2] * q[2] * commune(Math.hypot(p[0] - q[0], p[1] - q[1]));
            }
        }
        return Math.sqrt(carre * contraste / LARGEUR / HAUTEUR);
    }

    private static void ajouter(List<double[]> points, int n, double signe, boolean coins) {
        for (int k = 0; k < n * n; k++) {
            if (!coins || k % n % (n - 1) == 0 && k / n % (n - 1) == 0) {
                points.add(new double[] {(k % n + 0.5) / n, (k / n + 0.5) / n, signe / n / n});
            }
        }
    }

    /** L'aire commune à deux disques dont les centres sont à cette distance. */
    private double commune(double d) {
        return d >= 2 * rayon ? 0 : 2 * rayon * rayon * Math.acos(d / 2 / rayon) - d / 2 * Math.sqrt(4 * rayon * rayon - d * d);
    }
}
