package lancer.limites;

import static lancer.essai.Tirages.direction;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import lancer.Constantes;
import lancer.Point;
import lancer.Rayon;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Exact;
import lancer.essai.Formule;
import lancer.essai.Rangee;
import org.junit.jupiter.api.Test;

/**
 * Où même la bonne formule échoue, si elle n'a que des doubles : tout près d'une surface, et aux longueurs dont le carré n'est pas
 * un nombre. La suite de {@link LimitesIntersectionTest} ; la tolérance n'a plus que l'arrondi de la direction, 8u(1 + r/h)·t.
 */
class LimitesSurfaceTest {

    private static final double U = 0x1p-53;
    private static final double INFINI = Constantes.INFINI;

    /**
     * La demi-corde prise sur la perpendiculaire et les racines sans soustraction, en doubles : juste de loin
     * ({@link LimitesIntersectionTest#leDiscriminantDuManuelPerdUneSphereLointaine}), mais P − C y est arrondi d'abord, et
     * |P − C|² − r² perd autant de chiffres que P est près de la surface.
     */
    private static double enDoubles(Point P, Vecteur V, Point C, double r) {
        Vecteur f = new Vecteur(P, C);
        double b = f.dot(V);
        double h2 = r * r - f.sub(V.mul(b)).norme2();
        if (!(h2 >= 0)) {
            return INFINI;
        }
        double c = f.norme2() - r * r;
        if (c > 0) {
            return b > 0 ? c / (b + Math.sqrt(h2)) : INFINI;
        }
        return b > 0 ? b + Math.sqrt(h2) : c < 0 ? c / (b - Math.sqrt(h2)) : INFINI;
    }

    /** L'œil à hauteur d'homme au-dessus d'une Terre : en doubles, la distance du sol qu'il regarde n'est juste qu'à 1e-9, 1e-7 près. */
    @Test
    void dUnSolImmenseLesDoublesNeGardentQueQuelquesChiffres() {
        Random hasard = new Random(31);
        double pireEnDoubles = 0;
        double pire = 0;
        for (int k = 0; k < 2_000; k++) {
            double r = Math.pow(10, 4 + 5 * hasard.nextDouble());
            Point C = new Point(hasard.nextGaussian(), -r - 1, hasard.nextGaussian());
            Point P = new Point(hasard.nextGaussian(), 0.1 * hasard.nextGaussian(), hasard.nextGaussian());
            Point vers = P.add(new Vecteur(hasard.nextGaussian(), -0.1 - hasard.nextDouble(), hasard.nextGaussian()));
            Exact exact = new Exact(P, vers, C, r);
            Rayon rayon = new Rayon(P, vers);
            pireEnDoubles = Math.max(pireEnDoubles, Math.abs(enDoubles(P, rayon.getV(), C, r) / exact.distance - 1));
            double notre = exact.ecart(new Sphere(C, r).getIntersectionDistance(rayon));
            pire = Math.max(pire, Math.abs(new Sphere(C, r).getIntersectionDistance(rayon) / exact.distance - 1));
            assertTrue(notre <= 1, "graine 31, tirage " + k + ", r = " + r + " : " + notre + " tolérances");
        }
        assertTrue(pireEnDoubles > 1e-9, "erreur relative en doubles : " + pireEnDoubles);
        Rangee.montre("dUnSolImmenseLesDoublesNeGardentQueQuelquesChiffres", pireEnDoubles, pire, 0);
    }

    /** Le pied de la perpendiculaire est à moins d'un rayon : le départ n'avance pas, et c'est le manuel. */
    @Test
    void repartirDePresNeGagneRienAuDessusDUnSol() {
        Random hasard = new Random(36);
        double pire = 0;
        double pireNotre = 0;
        for (int k = 0; k < 2_000; k++) {
            double r = Math.pow(10, 4 + 5 * hasard.nextDouble());
            Point C = new Point(hasard.nextGaussian(), -r - 1, hasard.nextGaussian());
            Point P = new Point(hasard.nextGaussian(), 0, hasard.nextGaussian());
            Rayon rayon = new Rayon(P, new Vecteur(hasard.nextGaussian(), -0.1 - hasard.nextDouble(), hasard.nextGaussian()));
            double exacte = new Exact(P, P.add(rayon.getV()), C, r).distance;
            double reprise = Formule.REPRISE.distance(P, rayon.getV(), C, r);
            pire = Math.max(pire, Math.abs(reprise / exacte - 1));
            pireNotre = Math.max(pireNotre, Math.abs(new Sphere(C, r).getIntersectionDistance(rayon) / exacte - 1));
            assertEquals(exacte, new Sphere(C, r).getIntersectionDistance(rayon), 1e-13 * exacte, "graine 36, tirage " + k);
        }
        Rangee.montre("repartirDePresNeGagneRienAuDessusDUnSol", pire, pireNotre, 0);
        assertTrue(pire > 1e-9, "erreur relative : " + pire);
    }

    /** À quelques unités du dernier chiffre d'une surface, de quel côté est-on ? En doubles, pile ou face. */
    @Test
    void leCoteDUnPointPoseSurLaSurfaceSeJoueAPileOuFace() {
        Random hasard = new Random(32);
        int faussesEnDoubles = 0;
        int jugees = 0;
        for (int k = 0; k < 4_000; k++) {
            Point C = new Point(10 * hasard.nextGaussian(), 10 * hasard.nextGaussian(), 10 * hasard.nextGaussian());
            double r = Math.pow(10, 2 - 4 * hasard.nextDouble());
            Point P = C.add(direction(hasard).mul(r * (1 + (hasard.nextInt(129) - 64) * 0x1p-53)));
            Point vers = P.add(direction(hasard));
            Exact exact = new Exact(P, vers, C, r);
            if (Math.abs(exact.enfoncement) < 1e-9 * r) {
                continue;
            }
            jugees++;
            Rayon rayon = new Rayon(P, vers);
            double naive = enDoubles(P, rayon.getV(), C, r);
            faussesEnDoubles += exact.ecart(naive) > 1e6 ? 1 : 0;
            double notre = exact.ecart(new Sphere(C, r).getIntersectionDistance(rayon));
            assertTrue(notre <= 1, "graine 32, tirage " + k + " : " + notre + " tolérances");
        }
        assertTrue(faussesEnDoubles > jugees / 20, faussesEnDoubles + " fausses sur " + jugees);
    }

    @Test
    void auxLongueursDontLeCarreNEstPasUnNombreToutEstFaux() {
        Random hasard = new Random(33);
        for (double taille : new double[] {1e-300, 1e-200, 1e-160, 1e160, 1e200, 1e300}) {
            int faussesEnDoubles = 0;
            for (int k = 0; k < 300; k++) {
                Point P = new Point(0, 0, 0).add(direction(hasard).mul(3 * taille));
                Point C = new Point(0.1 * taille * hasard.nextGaussian(), 0, 0);
                double r = taille * (0.2 + hasard.nextDouble());
                Point vers = C.add(direction(hasard).mul(0.9 * r * hasard.nextDouble()));
                Exact exact = new Exact(P, vers, C, r);
                Rayon rayon = new Rayon(P, vers);
                faussesEnDoubles += exact.ecart(enDoubles(P, rayon.getV(), C, r)) > 1e6 ? 1 : 0;
                double notre = exact.ecart(new Sphere(C, r).getIntersectionDistance(rayon));
                assertTrue(notre <= 1, "graine 33, taille " + taille + ", tirage " + k + " : " + notre + " tolérances");
            }
            assertTrue(faussesEnDoubles > 250, "taille " + taille + " : " + faussesEnDoubles);
            Rangee.montre("auxLongueursDontLeCarreNEstPasUnNombreToutEstFaux", faussesEnDoubles, 0, 0);
        }
    }

    /** Le contact P + tV n'est sur sa sphère qu'à u·t près, soit 1e-4 rayon de si loin ; ramené à la distance r du centre, il y est. */
    @Test
    void leContactDUneSphereLointaineEstACoteDElle() {
        Random hasard = new Random(34);
        double pireNaif = 0;
        for (int k = 0; k < 2_000; k++) {
            Point C = new Point(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
            double r = 1;
            Point P = C.add(direction(hasard).mul(Math.pow(10, 2 + 9 * hasard.nextDouble())));
            Rayon rayon = new Rayon(P, C.add(direction(hasard).mul(0.9 * hasard.nextDouble())));
            double t = new Sphere(C, r).getIntersectionDistance(rayon);
            double naif = Math.abs(new Vecteur(C, P.add(rayon.getV().mul(t))).norme() - r);
            double notre = Math.abs(new Vecteur(C, rayon.calcContact()).norme() - r);
            pireNaif = Math.max(pireNaif, naif);
            // 4u(r + |C|), et ce que coûte de le vérifier en doubles
            assertEquals(0, notre, 8 * U * (r + new Vecteur(new Point(), C).norme()), "graine 34, tirage " + k);
        }
        assertTrue(pireNaif > 1e-6, "à côté de " + pireNaif);
    }
}
