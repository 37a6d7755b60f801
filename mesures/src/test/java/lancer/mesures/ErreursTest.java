package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.antialias.Antialias;
import lancer.contrat.Echantillonnage;
import lancer.dessin.Dessin;
import lancer.mesures.scenes.Scenes;
import lancer.scene.LecteurScene;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Dix des erreurs publiées, en petit, recalculées par la boucle la plus plate qui soit : aucune ligne n'en est à nous. */
class ErreursTest {

    private static final int L = 40;
    private static final int H = 30;

    /** Points d'un côté du pixel, pour chacune des deux vérités. */
    private static final int FIN = System.getProperty("tests.longs") != null ? 12 : 8;
    private static final int SANS_LIMITE = 40;

    private final List<double[]> spheres = new ArrayList<>();
    private final List<double[]> lampes = new ArrayList<>();
    private double seuil;

    private Scene lire(String nom) {
        Scene scene = Scenes.lire(LecteurScene.trouver("scenes/" + nom + ".ini"));
        for (Objet3D o : scene.getObjets()) {
            Point c = ((Sphere) o).getCentre();
            spheres.add(new double[] {c.x, c.y, c.z, ((Sphere) o).getRayon(), o.getKd().r, o.getKd().v, o.getKd().b, o.getKs().r,
                o.getKs().v, o.getKs().b, o.getNs()});
        }
        for (Lampe l : scene.getLampes()) {
            Point p = l.getPosition();
            Couleur k = l.getCouleur();
            lampes.add(new double[] {p.x, p.y, p.z, k.r, k.v, k.b});
        }
        return scene;
    }

    // ---- la boucle

    private static double[] vecteur(double... v) {
        double n = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        return new double[] {v[0] / n, v[1] / n, v[2] / n};
    }

    private static double scalaire(double[] u, double[] v) {
        return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    }

    private double distance(double[] p, double[] v, int k) {
        double[] s = spheres.get(k);
        double[] f = {s[0] - p[0], s[1] - p[1], s[2] - p[2]};
        double b = scalaire(f, v);
        double h2 = s[3] * s[3] - scalaire(f, f) + b * b;
        double t = h2 < 0 ? -1 : b - Math.sqrt(h2) > 0 ? b - Math.sqrt(h2) : b + Math.sqrt(h2);
        return t > 0 ? t : Double.POSITIVE_INFINITY;
    }

    private double[] voir(double[] p, double[] v, int sauf, int reflets, double[] produit) {
        int touchee = -1;
        double t = Double.POSITIVE_INFINITY;
        for (int k = 0; k < spheres.size(); k++) {
            if (k != sauf && distance(p, v, k) < t) {
                t = distance(p, v, k);
                touchee = k;
            }
        }
        if (touchee < 0) {
            Couleur ciel = new Rayon(new Point(), new Vecteur(v[0], v[1], v[2])).getSkyColor();
            return new double[] {ciel.r, ciel.v, ciel.b};
        }
        double[] s = spheres.get(touchee);
        double[] c = {p[0] + t * v[0], p[1] + t * v[1], p[2] + t * v[2]};
        double[] n = vecteur(c[0] - s[0], c[1] - s[1], c[2] - s[2]);
        double vn = 2 * scalaire(v, n);
        double[] r = vecteur(v[0] - vn * n[0], v[1] - vn * n[1], v[2] - vn * n[2]);
        double[] somme = new double[3];
        for (double[] lampe : lampes) {
            double[] d = {lampe[0] - c[0], lampe[1] - c[1], lampe[2] - c[2]};
            double[] l = vecteur(d);
            boolean cachee = scalaire(n, l) <= 0;
            for (int k = 0; k < spheres.size(); k++) {
                cachee |= k != touchee && distance(c, l, k) < Math.sqrt(scalaire(d, d));
            }
            for (int i = 0; i < 3 && !cachee; i++) {
                somme[i] += lampe[3 + i] * (s[4 + i] * scalaire(n, l) + s[7 + i] * Math.pow(Math.max(0, scalaire(r, l)), s[10]));
            }
        }
        double[] suite = {produit[0] * s[7], produit[1] * s[8], produit[2] * s[9]};
        double reste = Math.max(suite[0], Math.max(suite[1], suite[2]));
        if (reflets > 0 && reste > 0 && reste >= seuil) {
            double[] vue = voir(c, r, touchee, reflets - 1, suite);
            for (int i = 0; i < 3; i++) {
                somme[i] += s[7 + i] * vue[i];
            }
        }
        return somme;
    }

    private double[] point(double xe, double ye, int reflets) {
        Rayon rayon = new Camera(L, H).getRayon(xe, ye);
        Point p = rayon.getP();
        Vecteur v = rayon.getV();
        return voir(new double[] {p.x, p.y, p.z}, new double[] {v.x, v.y, v.z}, -1, reflets, new double[] {1, 1, 1});
    }

    /** La moyenne de la grille ; de ses quatre coins seulement s'ils se ressemblent à ce contraste près. */
    private double[] pixel(int k, int n, double contraste, int reflets) {
        double[] somme = new double[3];
        double[] min = {1, 1, 1};
        double[] max = new double[3];
        double[] coins = new double[3];
        for (int q = 0; q < n * n; q++) {
            double[] vu = point(k % L + (q % n + 0.5) / n, k / L + (q / n + 0.5) / n, reflets);
            boolean coin = (q % n == 0 || q % n == n - 1) && (q / n == 0 || q / n == n - 1);
            for (int i = 0; i < 3; i++) {
                somme[i] += vu[i] / n / n;
                coins[i] += coin ? vu[i] / 4 : 0;
                min[i] = coin ? Math.min(min[i], vu[i]) : min[i];
                max[i] = coin ? Math.max(max[i], Math.min(1, vu[i])) : max[i];
            }
        }
        boolean semblables = max[0] - min[0] <= contraste && max[1] - min[1] <= contraste && max[2] - min[2] <= contraste;
        return n > 2 && semblables ? coins : somme;
    }

    /** La moyenne d'un point au hasard dans chaque case de la grille, qui est sans biais ; celle de leurs milieux en a un. */
    private double[] juste(int k, Random hasard) {
        double[] somme = new double[3];
        for (int q = 0; q < FIN * FIN; q++) {
            double[] vu = point(k % L + (q % FIN + hasard.nextDouble()) / FIN, k / L + (q / FIN + hasard.nextDouble()) / FIN,
                    SANS_LIMITE);
            for (int i = 0; i < 3; i++) {
                somme[i] += vu[i] / FIN / FIN;
            }
        }
        return somme;
    }

    /** Le carré de l'erreur de chaque pixel, sans biais : deux vérités indépendantes, le produit de leurs écarts. */
    private double[] carres(int n, double contraste, int reflets, double sienSeuil) {
        Random hasard = new Random(1);
        double[] carres = new double[L * H];
        for (int k = 0; k < L * H; k++) {
            seuil = sienSeuil;
            double[] x = pixel(k, n, contraste, reflets);
            seuil = 0;
            double[] a = juste(k, hasard);
            double[] b = juste(k, hasard);
            for (int i = 0; i < 3; i++) {
                carres[k] += 255 * 255 * (Math.min(1, x[i]) - Math.min(1, a[i])) * (Math.min(1, x[i]) - Math.min(1, b[i])) / 3;
            }
        }
        return carres;
    }

    @Tag("long")
    @ParameterizedTest(name = "{0}, {1} × {1}, contraste {2}, {3} reflets, seuil 1/{4}")
    @CsvSource({"scene1, 1, -1, 5, 1024", "scene1, 2, -1, 5, 1024", "scene1, 3, -1, 5, 1024", "scene1, 3, 0.05, 5, 1024",
        "scene1, 1, -1, 0, 1024", "scene1, 1, -1, 2, 1024", "scene1, 1, -1, 1000, 16", "bowling, 1, -1, 5, 1024",
        "bowling, 2, -1, 5, 1024", "bowling, 3, 0.05, 5, 1024"})
    void uneErreurPublieeEstCelleDeLaBoucleLaPlusPlate(String nom, int n, double contraste, int reflets, double parties) {
        Scene scene = lire(nom);
        Echantillonnage grille = n == 1 ? Lancer::TracerPave : Antialias.coins(n, Math.max(0, contraste));
        Gabarit gabarit = new Gabarit(scene, L, H, 1, Gabarit.COTE, (i, j) -> true);
        ImageLineaire image = ImageLineaire.de(Dessin.lancer(scene.avec(scene.getModele().avec(grille, 1 / parties)), L, H,
                false), reflets, 2);
        double[] plate = carres(n, contraste, Math.min(reflets, SANS_LIMITE), 1 / parties);
        double[] publies = gabarit.carres(image);
        double moyenne = Arrays.stream(plate).average().getAsDouble();
        assertTrue(Math.sqrt(moyenne) > 0.3, "de quoi comparer");
        // pixel par pixel, les deux sont sans biais : ce qui les sépare n'est que le hasard, trois écarts types au plus
        double ecart = IntStream.range(0, L * H).mapToDouble(k -> publies[k] - plate[k]).average().getAsDouble();
        double type = Math.sqrt(IntStream.range(0, L * H).mapToDouble(k -> Math.pow(publies[k] - plate[k] - ecart, 2)).sum()) / L / H;
        assertTrue(type < 0.05 * moyenne, "une comparaison à " + type / moyenne + " près");
        assertTrue(Math.abs(ecart) <= 3 * type, Math.sqrt(moyenne) + " niveaux, à " + ecart / type + " écarts types");
    }
}
