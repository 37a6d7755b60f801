package lancer.precision;

import static lancer.essai.Ressources.fois;
import static lancer.essai.Tirages.direction;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Random;
import lancer.Constantes;
import lancer.Point;
import lancer.Rayon;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Exact;
import lancer.essai.Formule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * L'intersection contre la réponse exacte, là où elle est difficile : au-dessus d'un sol immense, à quelques unités du dernier chiffre de
 * la surface, en rasant, de loin. Tirages à graine fixe.
 */
class PrecisionTest {

    private static final double U = 0x1p-53;
    private static final long GRAINE = 20261122;
    private static final int TIRAGES = 1_500;

    private final Random hasard = new Random(GRAINE);

    private double signe() {
        return 2 * hasard.nextDouble() - 1;
    }

    /** Un nombre dont le logarithme est au hasard entre ceux de 10^a et de 10^b. */
    private double puissance(double a, double b) {
        return Math.pow(10, a + (b - a) * hasard.nextDouble());
    }

    private Point point(double echelle) {
        return new Point(signe() * echelle, signe() * echelle, signe() * echelle);
    }

    /** Un rayon de {@code p} vers {@code p2} et une sphère. */
    private static final class Cas {
        final Point p;
        final Point p2;
        final Point c;
        final double r;

        Cas(Point p, Point p2, Point c, double r) {
            this.p = p;
            this.p2 = p2;
            this.c = c;
            this.r = r;
        }

        double distance() {
            return new Sphere(c, r).getIntersectionDistance(new Rayon(p, p2));
        }

        @Override
        public String toString() {
            return "de " + p + " vers " + p2 + ", " + new Sphere(c, r);
        }
    }

    /** Les familles de tirages. */
    enum Famille { SOL, SURFACE, PROCHE, DEDANS, DOS, LOIN, RASANT, HORIZON, CHEVEU }

    private Cas tirer(Famille famille) {
        double r = puissance(-2, famille == Famille.SOL || famille == Famille.HORIZON ? 8 : 2);
        Point c = point(puissance(-2, 2));
        Vecteur n = direction(hasard);
        switch (famille) {
            case SOL:
                return new Cas(new Point(signe(), signe(), 0), new Point(signe(), -2 + signe(), 4), new Point(signe(), -r - 1, 6), r);
            case SURFACE:
                Point x = c.add(n.mul(r));
                Point p = new Point(x.x + (hasard.nextInt(129) - 64) * Math.ulp(x.x), x.y, x.z);
                return new Cas(p, p.add(direction(hasard).mul(r)), c, r);
            case PROCHE:
                return new Cas(c.add(n.mul(r * (0.7 + 0.9 * hasard.nextDouble()))), c.add(direction(hasard).mul(r * hasard.nextDouble())),
                        c, r);
            case DEDANS:
                Point q = c.add(n.mul(r * hasard.nextDouble()));
                return new Cas(q, q.add(direction(hasard).mul(r)), c, r);
            case DOS:
                // de l'intérieur, le dos tourné au centre : b et h y sont voisins
                Point o = c.add(n.mul(r * (0.5 + 0.45 * hasard.nextDouble())));
                return new Cas(o, o.add(n.add(direction(hasard).mul(puissance(-6, 0))).normalized().mul(r)), c, r);
            case CHEVEU:
                // au ras d'un grand sol : l et r ne diffèrent que de l'arrondi de l, et la puissance du départ décide
                double grand = puissance(0, 8);
                double haut = grand * puissance(-16, -6);
                double sinus = Math.sqrt(2 * haut / grand) * (1 + puissance(-12, -1));
                Vecteur v = new Vecteur(signe(), 0, signe()).normalized().mul(Math.sqrt(1 - sinus * sinus)).add(new Vecteur(0, -sinus, 0));
                Point oeil = new Point(0, haut, 0);
                return new Cas(oeil, oeil.add(3, v), new Point(0, -grand, 0), grand);
            case LOIN:
                return new Cas(c.add(n.mul(r * puissance(0, 12))), c.add(direction(hasard).mul(r * hasard.nextDouble())), c, r);
            case RASANT:
                return viser(c, r, n, r * puissance(0.05, 3), 1 + (hasard.nextBoolean() ? 1 : -1) * puissance(-16, -1));
            default:
                return viser(c, r, n, r * (1 + puissance(-10, -1)), Math.min(1, 1 - puissance(-14, -1)));
        }
    }

    /** De la distance f du centre, un rayon qui passe à {@code part} de r de celui-ci. */
    private Cas viser(Point c, double r, Vecteur n, double f, double part) {
        Vecteur w = direction(hasard);
        w = w.sub(n.mul(w.dot(n))).normalized();
        double sinus = Math.min(1, r / f * part);
        double cosinus = Math.sqrt(1 - sinus * sinus);
        Point p = c.add(n.mul(f));
        return new Cas(p, p.add(n.mul(-cosinus * f).add(w.mul(sinus * f))), c, r);
    }

    @ParameterizedTest
    @EnumSource
    void laDistanceNAPasPlusDErreurQueLArrondiDeLaDirectionNEnPermet(Famille famille) {
        int touches = 0;
        for (int k = 0; k < TIRAGES; k++) {
            Cas cas = tirer(famille);
            Exact exacte = new Exact(cas.p, cas.p2, cas.c, cas.r);
            if (!exacte.ambigu) {
                double ecart = exacte.ecart(cas.distance());
                assertTrue(ecart <= 1, "graine " + GRAINE + ", tirage " + k + ", " + cas + " : " + cas.distance() + ", exacte "
                        + exacte.distance + ", " + ecart + " tolérances");
                touches += exacte.distance == Constantes.INFINI ? 0 : 1;
            }
        }
        assertTrue(touches > TIRAGES / 4, touches + " touchées");
    }

    /** Celles des manuels : une fois sur dix au moins, la distance n'a pas dix chiffres justes, ou le contact est manqué ou inventé. */
    @ParameterizedTest
    @CsvSource({"LOIN, MANUEL", "LOIN, RACINES", "SOL, MANUEL", "SOL, RACINES", "SOL, REPRISE", "SOL, PERPENDICULAIRE", "SURFACE, MANUEL",
        "SURFACE, PERPENDICULAIRE", "SURFACE, EN_DOUBLES"})
    void uneAutreFormuleSeTrompeLaOuLaNotreEstJuste(Famille famille, Formule formule) {
        int fausses = 0;
        for (int k = 0; k < 300; k++) {
            Cas cas = tirer(famille);
            Exact exacte = new Exact(cas.p, cas.p2, cas.c, cas.r);
            if (!exacte.ambigu) {
                double distance = formule.distance(cas.p, new Rayon(cas.p, cas.p2).getV(), cas.c, cas.r);
                fausses += exacte.ecart(distance) > 1e5 ? 1 : 0;
            }
        }
        assertTrue(fausses > 300 / 10, fausses + " fausses");
    }

    @ParameterizedTest
    @EnumSource
    void enDouteAussiLeMiroirEtUnePuissanceDeDeuxNeChangentPasUnBit(Famille famille) {
        for (int k = 0; k < TIRAGES; k++) {
            Cas cas = tirer(famille);
            String dit = "graine " + GRAINE + ", tirage " + k + ", " + cas;
            assertEquals(cas.distance(), new Cas(miroir(cas.p), miroir(cas.p2), miroir(cas.c), cas.r).distance(), 0, dit);
            // 2^±700 : les carrés débordent, et la réponse est la même
            double f = Math.scalb(1.0, hasard.nextInt(1400) - 700);
            Cas autre = new Cas(fois(cas.p, f), fois(cas.p2, f), fois(cas.c, f), cas.r * f);
            assertEquals(cas.distance() * f, autre.distance(), 0, dit + ", facteur " + f);
        }
    }

    private static Point miroir(Point p) {
        return new Point(-p.x, p.y, p.z);
    }

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

    @Test
    void deLInterieurDosAuCentreLaSortieEstJusteAToutesLesTailles() {
        for (int k = 0; k < 20_000; k++) {
            double r = Math.pow(10, 20 * hasard.nextDouble() - 10);
            double part = hasard.nextDouble();
            // P est en (part r, 0, 0) et s'éloigne du centre : la sortie est à r − part r
            double attendue = exact(r).subtract(exact(part * r)).doubleValue();
            assertEquals(attendue, Intersection.distance(part * r, 0, 0, 1, 0, 0, 0, 0, 0, r), 8 * U * 2 * attendue,
                    "graine " + GRAINE + ", tirage " + k);
        }
    }
}
