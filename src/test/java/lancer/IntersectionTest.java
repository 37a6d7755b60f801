package lancer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import lancer.essai.Exact;
import org.junit.jupiter.api.Test;

/** L'intersection là où elle est mal placée : tangentes, centres, nombres qui n'en sont pas, longueurs aux bornes du domaine. */
class IntersectionTest {

    private static final double U = 0x1p-53;
    private static final double INFINI = Constantes.INFINI;

    private static double distance(Point p, Vecteur v, Point c, double r) {
        return Sphere.distance(p.x, p.y, p.z, v.x, v.y, v.z, c.x, c.y, c.z, r);
    }

    private static Vecteur direction(Random hasard) {
        return new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian()).normalized();
    }

    /** Un vecteur de longueur 1 perpendiculaire à celui-ci. */
    private static Vecteur perpendiculaire(Vecteur v, Random hasard) {
        Vecteur w = direction(hasard);
        return w.sub(v.mul(v.dot(w))).normalized();
    }

    /**
     * Le rayon passe à r(1 ± ε) du centre, ε de 1e-1 à 1e-17. L'arrondi change h² d'au plus δ = 8u·r(|P − C| + r), à peu près :
     * au-delà la réponse est sûre, en deçà touche et manque se valent, et la distance touchée est celle du pied à √(2δ) près.
     */
    @Test
    void presDUneTangenteLaReponseEstUneDesDeuxPossibles() {
        Random hasard = new Random(5);
        int touches = 0;
        int manques = 0;
        for (int k = 0; k < 8_000; k++) {
            double r = Math.pow(10, 2 - 6 * hasard.nextDouble());
            Vecteur v = direction(hasard);
            double ecart = Math.pow(10, -1 - 16 * hasard.nextDouble()) * (hasard.nextBoolean() ? 1 : -1);
            double avant = r * (0.5 + 20 * hasard.nextDouble());
            Point c = new Point(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
            Point p = c.add(perpendiculaire(v, hasard).mul(r * (1 - ecart))).sub(v.mul(avant));
            Point vers = p.add(v.mul(avant));
            Exact exact = new Exact(p, vers, c, r);
            double t = new Sphere(c, r).getIntersectionDistance(new Rayon(p, vers));
            double f = new Vecteur(p, c).norme();
            double doute = 8 * U * (f + r);
            String cas = "graine 5, tirage " + k + " : " + t + " au lieu de " + exact.distance;
            if (exact.enfoncement > doute) {
                assertEquals(exact.distance, t, exact.tolerance(8, p, c, r) + 16 * U * f, cas);
                touches++;
            } else if (exact.enfoncement < -doute) {
                assertEquals(INFINI, t, cas);
                manques++;
            } else {
                assertTrue(t == INFINI || Math.abs(t - Math.sqrt(f * f - r * r)) <= 2 * Math.sqrt(2 * r * doute), cas);
            }
        }
        assertTrue(touches > 2_000 && manques > 2_000, touches + " touchés, " + manques + " manqués");
    }

    /** {@code if (d < 0) return INFINI} laisserait passer NaN : c'est le contraire qui est écrit, {@code !(d >= 0)}. */
    @Test
    void unNombreQuiNEnEstPasUnNeToucheRien() {
        double[] cas = {0, 0, 0, 0, 0, 1, 0.1, 0.2, 5, 1};
        for (int place = 0; place < cas.length; place++) {
            for (double faux : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
                double[] x = cas.clone();
                x[place] = faux;
                double t = Sphere.distance(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9]);
                assertTrue(t > 0, "nombre de rang " + place + " changé en " + faux + " : " + t);
                assertTrue(t == INFINI || !Double.isNaN(faux), "NaN de rang " + place + " : " + t);
            }
        }
    }

    /** Au centre, b = 0 et c = −r² ; sur une tangente au départ, b = c = h = 0 : la racine c/q y serait 0/0. */
    @Test
    void auCentreOuSurUneTangenteAuDepartRienNEstDiviseParZero() {
        Random hasard = new Random(7);
        for (int k = 0; k < 2_000; k++) {
            Point c = new Point(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
            double r = Math.pow(10, 200 * hasard.nextDouble() - 100);
            assertEquals(r, distance(c, direction(hasard), c, r), 4 * U * r, "graine 7, tirage " + k);
        }
        // des triplets de Pythagore : le départ est exactement sur la sphère, et la tangente exactement tangente
        for (double f : new double[] {1, 0x1p-300, 0x1p300}) {
            for (double[] n : new double[][] {{3, 4, 0, 5}, {5, 12, 0, 13}, {0, 0, 1, 1}}) {
                Point p = new Point(n[0] * f, n[1] * f, n[2] * f);
                Vecteur tangente = n[2] == 0 ? new Vecteur(0, 0, 1) : new Vecteur(1, 0, 0);
                assertEquals(INFINI, distance(p, tangente, new Point(), n[3] * f));
                assertEquals(INFINI, distance(p, tangente.neg(), new Point(), n[3] * f));
            }
        }
    }

    /** Des longueurs de 1e-150 à 1e150, chaque scène à sa taille : les carrés y tiennent encore. */
    @Test
    void dansSonDomaineLUniteDeLongueurEstLibre() {
        Random hasard = new Random(8);
        for (int k = 0; k < 3_000; k++) {
            double taille = Math.pow(10, 298 * hasard.nextDouble() - 149);
            Point p = new Point(taille * hasard.nextGaussian(), taille * hasard.nextGaussian(), taille * hasard.nextGaussian());
            Point c = new Point(taille * hasard.nextGaussian(), taille * hasard.nextGaussian(), taille * hasard.nextGaussian());
            double r = taille * (0.05 + hasard.nextDouble());
            Point vers = c.add(direction(hasard).mul(1.2 * r * hasard.nextDouble()));
            Exact exact = new Exact(p, vers, c, r);
            double t = new Sphere(c, r).getIntersectionDistance(new Rayon(p, vers));
            boolean douteux = Math.abs(exact.enfoncement) < 1e-12 * taille;
            assertTrue(douteux || t == exact.distance || Math.abs(t - exact.distance) <= exact.tolerance(8, p, c, r),
                    "graine 8, tirage " + k + ", taille " + taille + " : " + t + " au lieu de " + exact.distance);
        }
    }
}
