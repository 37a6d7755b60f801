package lancer.cours;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import lancer.Couleur;
import lancer.Point;
import lancer.Tests;
import lancer.Tuple;
import lancer.Vecteur;
import org.junit.jupiter.api.Test;

/** Ce que le programme promet des points, vecteurs et couleurs, au-delà de ce que le cours demande dans {@link Tests}. */
class ExigencesTripletsTest {

    private static final double PRES = 1e-12;
    private static final double[] VALEURS = {0, 1, -1, 2, 0.5, 1e100, Double.NaN, Double.POSITIVE_INFINITY};

    private final Vecteur u = new Vecteur(1, 2, 3);
    private final Vecteur v = new Vecteur(4, -5, 6);
    private final Couleur c = new Couleur(0.2, 0.4, 0.6);
    private final Couleur d = new Couleur(0.5, 1, 2);

    static void assertCouleur(double r, double v, double b, Couleur c) {
        assertEquals(r, c.r, PRES, "rouge de " + c);
        assertEquals(v, c.v, PRES, "vert de " + c);
        assertEquals(b, c.b, PRES, "bleu de " + c);
    }

    /** Ce qui est fait de trois nombres ; une couleur n'est pas un {@link Tuple}, et se compare de même. */
    private static List<Function<double[], Object>> fabriques() {
        return List.of(t -> new Tuple(t[0], t[1], t[2]), t -> new Vecteur(t[0], t[1], t[2]),
                t -> new Point(t[0], t[1], t[2]), t -> new Couleur(t[0], t[1], t[2]));
    }

    @Test
    void unTripletNEstEgalAUnAutreQueSiChaqueComposanteLEst() {
        for (Function<double[], Object> fait : fabriques()) {
            for (double x : VALEURS) {
                double[] t = {x, 3, 4};
                assertEquals(fait.apply(t), fait.apply(t.clone()));
                for (int k = 0; k < 3; k++) {
                    double[] autre = t.clone();
                    autre[k] = 7;
                    assertNotEquals(fait.apply(t), fait.apply(autre));
                }
            }
            assertNotEquals(fait.apply(new double[3]), fait.apply(new double[] {-0.0, 0, 0}));
            assertNotEquals(fait.apply(new double[3]), "0 0 0");
            assertNotEquals(fait.apply(new double[3]), null);
        }
    }

    @Test
    void unTupleSansArgumentEstNulEtNEstPasEgalAUnTupleDUneAutreClasse() {
        assertEquals(new Tuple(0, 0, 0), new Tuple());
        assertNotEquals(new Point(1, 2, 3), new Vecteur(1, 2, 3));
    }

    /** Un code ne doit rien de plus qu'être égal pour des égaux ; mais s'il confond tout, une table n'est plus qu'une liste. */
    @Test
    void unTripletAPresqueToujoursUnCodeQueSesVoisinsNOntPas() {
        for (Function<double[], Object> fait : fabriques()) {
            Set<Integer> codes = new HashSet<>();
            for (int k = 0; k < 1000; k++) {
                double[] t = {k / 100 / 10.0, k / 10 % 10 / 10.0, k % 10 / 10.0};
                codes.add(fait.apply(t).hashCode());
                assertEquals(fait.apply(t).hashCode(), fait.apply(t.clone()).hashCode());
            }
            assertTrue(codes.size() > 900, codes.size() + " codes pour 1000 triplets");
        }
    }

    @Test
    void unVecteurNulOuInfiniNeSeNormalisePas() {
        assertThrows(ArithmeticException.class, () -> new Vecteur().normalized());
        assertThrows(ArithmeticException.class, () -> Vecteur.normalize(new Vecteur(1, Double.NaN, 0)));
        assertThrows(ArithmeticException.class, () -> new Vecteur(Double.POSITIVE_INFINITY, 0, 0).normalized());
    }

    @Test
    void lesAutresFormesStatiquesOntLeMemeResultat() {
        assertEquals(u.add(v), Vecteur.add(u, v));
        assertEquals(u.mul(3), Vecteur.mul(u, 3));
        assertEquals(u.div(3), Vecteur.div(u, 3));
        assertEquals(new Vecteur(-1, -2, -3), u.neg());
        assertEquals(u.neg(), Vecteur.neg(u));
        Point p = new Point(1, 2, 3);
        assertEquals(p.add(v), Point.add(p, v));
        assertEquals(c.add(d), Couleur.add(c, d));
        assertEquals(c.sub(d), Couleur.sub(c, d));
        assertEquals(c.mul(d), Couleur.mul(c, d));
        assertEquals(c.mul(2), Couleur.mul(c, 2));
        assertEquals(c.div(2), Couleur.div(c, 2));
    }

    @Test
    void uneCouleurEstFinieQuandSesTroisComposantesLeSont() {
        for (double x : VALEURS) {
            boolean finie = !Double.isNaN(x) && !Double.isInfinite(x);
            assertTrue(finie == new Couleur(x, 0, 0).estFinie() && finie == new Couleur(0, x, 0).estFinie()
                    && finie == new Couleur(0, 0, x).estFinie(), "composante " + x);
        }
    }

    @Test
    void uneCouleurParDefautEstNoireEtAUnSeulArgumentGrise() {
        assertCouleur(0, 0, 0, new Couleur());
        assertCouleur(0.3, 0.3, 0.3, new Couleur(0.3));
    }

    @Test
    void uneCouleurSeCalculeComposanteParComposante() {
        assertCouleur(0.7, 1.4, 2.6, c.add(d));
        assertCouleur(-0.3, -0.6, -1.4, c.sub(d));
        assertCouleur(0.1, 0.4, 1.2, c.mul(d));
        assertCouleur(0.4, 0.8, 1.2, c.mul(2));
        assertCouleur(0.1, 0.2, 0.3, c.div(2));
    }

    /** Autour de chaque moitié : {@code floor(x + 1/2)} arrondit deux fois, et peut atteindre l'entier du dessus. */
    @Test
    void unNiveauEstLArrondiExactDuProduitPar255() {
        for (int niveau = 0; niveau < 255; niveau++) {
            double x = (niveau + 0.5) / 255;
            for (int k = 0; k < 20; k++) {
                x = Math.nextDown(x);
            }
            for (int k = 0; k < 40; k++, x = Math.nextUp(x)) {
                int attendu = new BigDecimal(x * 255).setScale(0, RoundingMode.HALF_UP).intValueExact();
                assertEquals(attendu, new Couleur(0, 0, x).getCode() & 0xFF, "composante " + x);
            }
        }
    }

    @Test
    void uneCouleurSeLimiteSeulementDansSonCode() {
        assertEquals(0xFFFF0000, new Couleur(7, -3, 0).getCode());
        assertEquals(0xFF66FF00, new Couleur(0.4, 1.5, 0).getCode(), "le vert ne déborde pas dans le rouge");
    }

    @Test
    void uneCouleurInfinieOuQuiNEstPasUnNombreAQuandMemeUnCode() {
        assertEquals(0xFF00FF00, new Couleur(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY).getCode());
        assertEquals(0xFF000000, new Couleur(-0.0).getCode());
    }
}
