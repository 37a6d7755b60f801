package lancer.precision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Random;
import lancer.Constantes;
import lancer.Point;
import lancer.Sphere;
import lancer.Vecteur;
import org.junit.jupiter.api.Test;

/**
 * Ce que les mutations de {@link Sphere} et d'{@link IntersectionCompensee} ont montré que personne ne vérifiait : la puissance d'un
 * point à ses tout derniers chiffres, les tangentes rasantes, les sphères réduites à un point. Voir docs/mutations.md.
 */
class PresDeLaSurfaceTest {

    private static final double U = 0x1p-53;
    private static final long GRAINE = 61;

    private final Random hasard = new Random(GRAINE);

    private static BigDecimal exact(double x) {
        return new BigDecimal(x);
    }

    /** |f + e|² − r², sans arrondi. */
    private static BigDecimal puissanceExacte(double[] f, double[] e, double r) {
        BigDecimal somme = exact(r).multiply(exact(r)).negate();
        for (int k = 0; k < 3; k++) {
            BigDecimal x = exact(f[k]).add(exact(e[k]));
            somme = somme.add(x.multiply(x));
        }
        return somme;
    }

    @Test
    void laPuissanceDUnPointEstJusteADeuxPuissanceMoins53OuA2PuissanceMoins127R2Pres() {
        int presque = 0;
        for (int k = 0; k < 15_000; k++) {
            double r = Math.scalb(1 + hasard.nextDouble(), hasard.nextInt(40) - 20);
            Vecteur n = new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian() * Math.pow(10, -hasard.nextInt(8)))
                    .normalized();
            // de un millième du rayon à son dernier chiffre
            double ecart = hasard.nextInt(3) == 0 ? 0 : Math.pow(10, -3 - 13 * hasard.nextDouble()) * (hasard.nextBoolean() ? 1 : -1);
            double[] f = {n.x * r * (1 + ecart), n.y * r * (1 + ecart), n.z * r * (1 + ecart)};
            double[] e = new double[3];
            double reste = puissanceExacte(f, e, r).doubleValue();
            boolean annule = hasard.nextBoolean();
            for (int i = 0; i < 3; i++) {
                double demi = Math.ulp(f[i]) / 2;
                // le second terme au hasard, ou celui qui annule presque tout
                double voulu = annule ? -reste * f[i] / (2 * r * r) : demi * (2 * hasard.nextDouble() - 1);
                e[i] = Math.max(-demi, Math.min(demi, voulu));
            }
            BigDecimal juste = puissanceExacte(f, e, r);
            double c = IntersectionCompensee.puissance(f[0], f[1], f[2], e[0], e[1], e[2], r);
            double erreur = exact(c).subtract(juste).abs().doubleValue();
            double permise = U * Math.abs(juste.doubleValue()) + 0x1p-127 * r * r;
            assertTrue(erreur <= permise, "graine " + GRAINE + ", tirage " + k + " : " + juste.doubleValue() / (r * r) + " r², erreur "
                    + erreur / permise);
            presque += Math.abs(juste.doubleValue()) < 1e-24 * r * r ? 1 : 0;
        }
        assertTrue(presque > 100, presque + " puissances presque nulles");
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
        return Sphere.distance(-f[0], -f[1], -f[2], v[0], v[1], v[2], 0, 0, 0, r);
    }

    /** Le long d'un axe, à (3, 4)·s de côté d'une sphère de rayon 5 s, tout est exact : seul un chiffre de r sépare le contact du vide. */
    @Test
    void uneTangenteRasanteEstUnContactEtUnChiffreDeMoinsAuRayonNEnEstPasUn() {
        surChaqueAxe((v, axe, a, b) -> {
            for (int k = 0; k < 3000; k++) {
                double s = Math.scalb(1.0, hasard.nextInt(200) - 100);
                double[] f = new double[3];
                double t = 5 * s * Math.pow(2, -1 - 24 * hasard.nextDouble());
                f[axe] = v[axe] * t;
                f[a] = 3 * s;
                f[b] = -4 * s;
                String cas = "graine " + GRAINE + ", tirage " + k + ", s = " + s + ", t = " + t;
                assertEquals(t, distance(f, v, 5 * s), 4 * U * t, cas);
                assertEquals(Constantes.INFINI, distance(f, v, Math.nextDown(5 * s)), cas + ", rayon plus court");
                double dedans = distance(f, v, Math.nextUp(5 * s));
                assertTrue(t < 1e-7 * s ? dedans > 0 : dedans < t, cas + ", rayon plus long : " + dedans);
                f[axe] = -f[axe];
                assertEquals(Constantes.INFINI, distance(f, v, 5 * s), cas + ", derrière");
            }
        });
    }

    /**
     * De même quand C − P n'est pas un double : arrondi, il passe d'un côté ou de l'autre du vrai, et h² peut en devenir négatif ; la
     * perpendiculaire, elle, reste juste. Un h² d'un arrondi fait une demi-corde de √u : c'est ce que vaut alors la distance.
     */
    @Test
    void uneTangenteDontLaDistanceEstArrondieEnEstEncoreUne() {
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
                String cas = "graine " + GRAINE + ", tirage " + k + ", s = " + s + ", t = " + t;
                assertEquals(t, distance(p, v, c, 5 * s), 2 * Math.sqrt(U) * t, cas);
                assertEquals(Constantes.INFINI, distance(p, v, c, Math.nextDown(5 * s)), cas + ", rayon plus court");
            }
        });
    }

    private static double distance(double[] p, double[] v, double[] c, double r) {
        return Sphere.distance(p[0], p[1], p[2], v[0], v[1], v[2], c[0], c[1], c[2], r);
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
                assertEquals(Constantes.INFINI, distance(f, v, r), "vers l'extérieur");
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
                    assertEquals(Constantes.INFINI, distance(f, v, r), "à côté");
                    f[travers] = 0;
                }
                f[axe] = -f[axe];
                assertEquals(Constantes.INFINI, distance(f, v, r), "derrière");
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
        assertEquals(new Point(1, 0, 0), new Sphere(new Point(), 1).getPointDeSurface(new Point(max, 0, 0)));
        assertEquals(new Point(0, 0, -3), new Sphere(new Point(), 3).getPointDeSurface(new Point(0, 0, -Double.MIN_VALUE)));
    }

    @Test
    void leCentreNeSeRameneNullePart() {
        Point centre = new Point(1, 2, 3);
        assertSame(centre, new Sphere(new Point(1, 2, 3), 5).getPointDeSurface(centre));
        Point infini = new Point(1, Constantes.INFINI, 3);
        assertSame(infini, new Sphere(centre, 5).getPointDeSurface(infini));
    }

    @Test
    void lEcartALaSurfaceSeMesureAussiDeLoin() {
        for (double r : new double[] {1e-30, 1e-10, 0.5, 1, 2, 1e10, 1e30}) {
            for (double norme : new double[] {0.25, 0.5, 0.999, 1, 1.001, 2, 4}) {
                double carre = (norme * r) * (norme * r);
                assertEquals(1 - 1 / norme, Norme.ecart(carre, r), 4 * U * Math.max(1, 1 / norme), "r = " + r + ", à " + norme + " r");
            }
            double colle = r * (1 + 1e-12);
            assertEquals(1e-12, Norme.ecart(colle * colle, r), 8 * U);
        }
        assertEquals(-1, Norme.ecart(1, 2));
    }

    /** C'est ce qui permet d'écarter une sphère sans reprendre le calcul : une borne de zéro serait juste, et ne servirait à rien. */
    @Test
    void uneDistanceEnDouteSAnnonceAUnDixMilliemePres() {
        int annoncees = 0;
        for (int k = 0; k < 20_000; k++) {
            double r = Math.pow(10, 4 * hasard.nextDouble());
            Vecteur n = new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian()).normalized();
            Vecteur p = n.mul(r * (1 + Math.pow(10, -5 * hasard.nextDouble())));
            Vecteur v = new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian()).sub(n).normalized();
            double d = Sphere.distanceOuDoute(p.x, p.y, p.z, v.x, v.y, v.z, 0, 0, 0, r);
            double t = Sphere.distance(p.x, p.y, p.z, v.x, v.y, v.z, 0, 0, 0, r);
            if (d < -Double.MIN_VALUE) {
                annoncees++;
                assertTrue(Doute.auMoins(d) <= t && Doute.auMoins(d) >= 0.9997 * t, "graine " + GRAINE + ", tirage " + k + " : "
                        + Doute.auMoins(d) + " pour " + t);
            }
        }
        assertTrue(annoncees > 5000, annoncees + " doutes");
    }

    @Test
    void deLInterieurDosAuCentreLaSortieEstJusteAToutesLesTailles() {
        for (int k = 0; k < 20_000; k++) {
            double r = Math.pow(10, 20 * hasard.nextDouble() - 10);
            double part = hasard.nextDouble();
            double[] f = {-part * r, 0, 0};
            // P est en (part r, 0, 0) et s'éloigne du centre : la sortie est à r − part r
            double attendue = exact(r).subtract(exact(part * r)).doubleValue();
            assertEquals(attendue, distance(f, new double[] {1, 0, 0}, r), 8 * U * 2 * attendue, "graine " + GRAINE + ", tirage " + k);
        }
    }
}
