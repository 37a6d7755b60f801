package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Ce que l'on sait d'une image par quelques-uns de ses pixels. */
class MesureTest {

    private static final double[] EGAUX = {1, 1, 1, 1};

    @Test
    void chaquePixelCompteCommeLInverseDeSaChance() {
        assertEquals(2, new Mesure(EGAUX, new double[] {1, 3, 5, 7}).erreur, "tous mesurés : la moyenne");
        // neuf dixièmes de l'image à 1, un dixième à 31
        assertEquals(2, new Mesure(new double[] {45, 45, 5, 5}, new double[] {1, 1, 31, 31}).erreur, 1e-12);
        assertEquals(0, new Mesure(EGAUX, new double[] {-1, -3, 0, 0}).erreur, "une moyenne négative est une erreur nulle");
    }

    @Test
    void deuxReglagesSeComparentSansLeHasardDeLeursReferences() {
        double[] hasard = {900, -800, 700, -600};
        Mesure avant = new Mesure(EGAUX, hasard);
        Mesure apres = new Mesure(EGAUX, Arrays.stream(hasard).map(c -> c - 4).toArray());
        assertEquals(2, avant.moins(apres).plus(-1.64), 1e-9);
        assertTrue(avant.plus(1.64) > 10, "le hasard n'est pas caché pour autant");
    }

    /** Un seul écart vu : trois autres, aussi grands, ont pu manquer, mais non l'inverse. */
    @Test
    void ceQuiEstRareAPuManquer() {
        double[] carres = new double[100];
        double[] poids = new double[100];
        Arrays.fill(poids, 1);
        carres[0] = 100;
        Mesure mesure = new Mesure(poids, carres);
        assertEquals(1, mesure.erreur, 1e-12);
        assertEquals(Math.sqrt(1 + 1.96 * Math.hypot(1, 3.69 / 1.96)), mesure.plus(1.96), 0.01);
        assertEquals(0, mesure.plus(-1.96), "il a pu ne pas y en avoir d'autre");
    }
}
