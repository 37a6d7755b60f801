package lancer.limites;

import static lancer.essai.Tirages.direction;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import lancer.Constantes;
import lancer.Point;
import lancer.Rayon;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Exact;
import lancer.precision.Intersection;
import org.junit.jupiter.api.Test;

/** L'intersection là où elle est mal placée : tangentes, centres, nombres qui n'en sont pas, longueurs aux bornes du domaine. */
class IntersectionTest {

    private static final double U = 0x1p-53;
    private static final double INFINI = Constantes.INFINI;

    private static double distance(Point p, Vecteur v, Point c, double r) {
        return Intersection.distance(p.x, p.y, p.z, v.x, v.y, v.z, c.x, c.y, c.z, r);
    }

    /** Un vecteur de longueur 1 perpendiculaire à celui-ci. */
    private static Vecteur perpendiculaire(Vecteur v, Random hasard) {
        Vecteur w = direction(hasard);
        return w.sub(v.mul(v.dot(w))).normalized();
    }

    /** {@code if (d < 0) return INFINI} laisserait passer NaN : c'est le contraire qui est écrit, {@code !(d >= 0)}. */
    @Test
    void unNombreQuiNEnEstPasUnNeToucheRien() {
        // de loin, puis du centre, de la surface et tout près d'elle
        double[][] tous = {{0, 0, 0, 0, 0, 1, 0.1, 0.2, 5, 1}, {0, 0, 0, 0, 0, 1, 0, 0, 0, 1}, {0.99999, 0, 0, 0, 0, 1, 0, 0, 0, 1},
            {1, 0, 0, 0, 0, 1, 0, 0, 0, 1}, {1.00001, 0, 0, 0, 0, 1, 0, 0, 0, 1}};
        for (double[] cas : tous) {
            for (int place = 0; place < cas.length; place++) {
                for (double faux : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
                    double[] x = cas.clone();
                    x[place] = faux;
                    double t = Intersection.distance(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9]);
                    assertTrue(t > 0, "nombre de rang " + place + " changé en " + faux + " : " + t);
                    assertTrue(t == INFINI || !Double.isNaN(faux), "NaN de rang " + place + " : " + t);
                }
            }
        }
    }

    /** Trois axes, deux sens. */
    private interface Axe {
        void essayer(double[] v, int long0, int travers1, int travers2);
    }

    private static void surChaqueAxe(Axe axe) {
        for (int k = 0; k < 3; k++) {
            for (double sens : new double[] {1, -1}) {
                double[] v = new double[3];
                v[k] = sens;
                axe.essayer(v, k, (k + 1) % 3, (k + 2) % 3);
            }
        }
    }

    private static double distance(double[] f, double[] v, double r) {
        return Intersection.distance(-f[0], -f[1], -f[2], v[0], v[1], v[2], 0, 0, 0, r);
    }

    /** Le long d'un axe, à (3, 4)·s de côté d'une sphère de rayon 5 s, tout est exact : seul un chiffre de r sépare le contact du vide. */
    @Test
    void uneTangenteRasanteEstUnContactEtUnChiffreDeMoinsAuRayonNEnEstPasUn() {
        Random hasard = new Random(61);
        surChaqueAxe((v, axe, a, b) -> {
            for (int k = 0; k < 3000; k++) {
                double s = Math.scalb(1.0, hasard.nextInt(200) - 100);
                double[] f = new double[3];
                // de tout près, où la puissance du départ est calculée finement, à dix rayons
                double t = 5 * s * Math.pow(2, 4 - 29 * hasard.nextDouble());
                f[axe] = v[axe] * t;
                f[a] = 3 * s;
                f[b] = -4 * s;
                String cas = "graine 61, tirage " + k + ", s = " + s + ", t = " + t;
                assertEquals(t, distance(f, v, 5 * s), 8 * U * t, cas);
                assertEquals(INFINI, distance(f, v, Math.nextDown(5 * s)), cas + ", rayon plus court");
                double dedans = distance(f, v, Math.nextUp(5 * s));
                assertTrue(t < 1e-7 * s ? dedans > 0 : dedans < t, cas + ", rayon plus long : " + dedans);
                f[axe] = -f[axe];
                assertEquals(INFINI, distance(f, v, 5 * s), cas + ", derrière");
            }
        });
    }

    /**
     * De même quand C − P n'est pas un double : arrondi, il passe d'un côté ou de l'autre du vrai, et h² peut en devenir négatif ; la
     * perpendiculaire, elle, reste juste. Un h² d'un arrondi fait une demi-corde de √u : c'est ce que vaut alors la distance.
     */
    @Test
    void uneTangenteDontLaDistanceEstArrondieEnEstEncoreUne() {
        Random hasard = new Random(61);
        surChaqueAxe((v, axe, a, b) -> {
            for (int k = 0; k < 1000; k++) {
                double s = Math.scalb(1.0, hasard.nextInt(200) - 100);
                double[] c = new double[3];
                double[] p = new double[3];
                c[axe] = v[axe] * s * (1 + 3 * hasard.nextDouble());
                p[axe] = -v[axe] * s * hasard.nextDouble() / 8;
                c[a] = 3 * s;
                c[b] = -4 * s;
                double t = Math.abs(c[axe] - p[axe]);
                String cas = "graine 61, tirage " + k + ", s = " + s + ", t = " + t;
                assertEquals(t, distance(p, v, c, 5 * s), 2 * Math.sqrt(U) * t, cas);
                assertEquals(INFINI, distance(p, v, c, Math.nextDown(5 * s)), cas + ", rayon plus court");
            }
        });
    }

    private static double distance(double[] p, double[] v, double[] c, double r) {
        return Intersection.distance(p[0], p[1], p[2], v[0], v[1], v[2], c[0], c[1], c[2], r);
    }

    @Test
    void unDepartExactementSurLaSurfaceTraverseOuSEnVa() {
        surChaqueAxe((v, axe, a, b) -> {
            for (int k = -400; k <= 400; k += 50) {
                double[] f = new double[3];
                f[axe] = v[axe] * Math.scalb(3.0, k);
                f[a] = Math.scalb(4.0, k);
                double r = Math.scalb(5.0, k);
                assertEquals(Math.scalb(6.0, k), distance(f, v, r), "vers l'intérieur : la corde entière");
                f[axe] = -f[axe];
                assertEquals(INFINI, distance(f, v, r), "vers l'extérieur");
                f[axe] = 0;
                f[b] = Math.scalb(3.0, k);
                assertEquals(INFINI, distance(f, v, r), "tangent, où c/q est 0/0");
                assertEquals(r, distance(new double[3], v, r), 4 * U * r, "du centre");
            }
        });
    }

    @Test
    void uneSphereReduiteAUnPointEstToucheeParCeQuiYPasseEtNonACote() {
        surChaqueAxe((v, axe, a, b) -> {
            for (int k = -300; k <= 300; k += 100) {
                double loin = Math.scalb(1.5, k);
                double r = Math.scalb(loin, -500);
                double[] f = new double[3];
                f[axe] = v[axe] * loin;
                assertEquals(loin, distance(f, v, r), "en plein centre");
                for (int travers : new int[] {a, b}) {
                    f[travers] = r;
                    assertEquals(loin, distance(f, v, r), "tangente");
                    f[travers] = -2 * r;
                    assertEquals(INFINI, distance(f, v, r), "à côté");
                    f[travers] = 0;
                }
                f[axe] = -f[axe];
                assertEquals(INFINI, distance(f, v, r), "derrière");
            }
        });
    }

    @Test
    void auBoutDesDoublesUneSphereEstEncoreTouchee() {
        double max = Double.MAX_VALUE;
        surChaqueAxe((v, axe, a, b) -> {
            double[] f = new double[3];
            f[axe] = v[axe] * max;
            assertEquals(0.75 * max, distance(f, v, 0.25 * max), 4 * U * max);
            f[axe] = 0;
            assertEquals(max, distance(f, v, max), 4 * U * max);
        });
        assertEquals(new Point(1, 0, 0), new Sphere(new Point(), 1).getPointDeSurface(new Point(max, 0, 0), INFINI));
        assertEquals(new Point(0, 0, -3),
                new Sphere(new Point(), 3).getPointDeSurface(new Point(0, 0, -Double.MIN_VALUE), INFINI));
    }

    /** P + tV n'est sur sa sphère qu'à u·t près ; ramené à la distance r du centre, le contact y est. */
    @Test
    void leContactDUneSphereLointaineEstSurElle() {
        Random hasard = new Random(34);
        double pireNaif = 0;
        for (int k = 0; k < 2_000; k++) {
            Point C = new Point(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
            Sphere sphere = new Sphere(C, 1);
            Point P = C.add(direction(hasard).mul(Math.pow(10, 2 + 9 * hasard.nextDouble())));
            Rayon rayon = new Rayon(P, C.add(direction(hasard).mul(0.9 * hasard.nextDouble())));
            double t = sphere.getIntersectionDistance(rayon);
            pireNaif = Math.max(pireNaif, Math.abs(new Vecteur(C, P.add(t, rayon.getV())).norme() - 1));
            // 4u(r + |C|), et ce que coûte de le vérifier en doubles
            double ecart = new Vecteur(C, rayon.calcContact()).norme() - 1;
            assertEquals(0, ecart, 8 * U * (1 + new Vecteur(new Point(), C).norme()), "graine 34, tirage " + k);
        }
        assertTrue(pireNaif > 1e-6, "à côté de " + pireNaif);
    }

    /** Ramené sur sa sphère, il s'en écarterait de 4 u r, autant que la hauteur d'une lampe qui rase un grand sol. */
    @Test
    void unContactPlusProcheQueLeRayonNEstADistanceDeSaSphereQueParLesArrondisDeCeQuiEstProche() {
        Random hasard = new Random(52);
        double rameneEnRayons = 0;
        for (int k = 0; k < 2_000; k++) {
            double r = Math.pow(10, 1 + 11 * hasard.nextDouble());
            Point C = new Point().add(direction(hasard).mul(r));
            Point P = new Point(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
            Sphere sphere = new Sphere(C, r);
            Rayon rayon = new Rayon(P, direction(hasard));
            double t = sphere.getIntersectionDistance(rayon);
            if (t < r) {
                double ecart = Exact.ecartALaSurface(rayon.calcContact(), C, r);
                assertEquals(0, ecart, 16 * U * (t + new Vecteur(new Point(), P).norme()), "graine 52, tirage " + k + ", r = " + r);
                Point ramene = sphere.getPointDeSurface(P.add(t, rayon.getV()), INFINI);
                rameneEnRayons = Math.max(rameneEnRayons, Exact.ecartALaSurface(ramene, C, r) / r);
            }
        }
        assertTrue(rameneEnRayons > U / 2, "ramenés, ils en sont à " + rameneEnRayons + " r");
    }

    @Test
    void leCentreNeSeRameneNullePart() {
        Point centre = new Point(1, 2, 3);
        assertSame(centre, new Sphere(new Point(1, 2, 3), 5).getPointDeSurface(centre, INFINI));
        Point infini = new Point(1, INFINI, 3);
        assertSame(infini, new Sphere(centre, 5).getPointDeSurface(infini, INFINI));
    }
}
