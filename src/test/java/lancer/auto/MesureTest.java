package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Locale;
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
        Arrays.fill(poids, 20);
        carres[0] = 100;
        Mesure mesure = new Mesure(poids, carres);
        assertEquals(1, mesure.erreur, 1e-12);
        assertEquals(Math.sqrt(1 + 1.96 + 3.69), mesure.plus(1.96), 0.01, "ce que le hasard ôte, et ce qui a pu manquer, s'ajoutent");
        assertEquals(0, mesure.plus(-1.96), "il a pu ne pas y en avoir d'autre");
        String hasard = " ; pixels tirés au hasard : un détail plus petit que 1/33 de l'image a pu échapper";
        assertEquals("erreur de 1.00 ± 1.58 hors détails rares" + hasard, mesure.enMots());
        Arrays.fill(carres, 0, 30, 100);
        assertEquals("erreur de 5.48 ± 1.06" + hasard, new Mesure(poids, carres).enMots(), "trente écarts ne sont pas rares");
        Arrays.fill(poids, 1);
        Arrays.fill(carres, 1, 30, 0);
        assertEquals("erreur de 1.00 ± 1.58", new Mesure(poids, carres).enMots(), "tous les pixels sont mesurés");
    }

    @Test
    void uneEstimationNegativeNeDonneQueSaBorne() {
        Mesure mesure = new Mesure(new double[] {20, 20, 20, 20, 20, 20, 20, 20}, new double[] {-3, -3, -3, -3, 1, 1, 1, 1});
        assertEquals(0, mesure.erreur);
        assertEquals("erreur d'au plus " + String.format(Locale.ROOT, "%.2f", mesure.plus(1.96))
                + " ; pixels tirés au hasard : un détail plus petit que 1/3 de l'image a pu échapper", mesure.enMots());
        assertEquals(mesure.plus(1.96), mesure.incertitude);
    }

    @Test
    void cinqPixelsNeDonnentPasDIntervalleNiCeuxQuiSontTousJustes() {
        double[] six = {9, 1, 9, 1, 9, 1};
        assertTrue(new Mesure(new double[] {1, 1, 1, 1, 1, 1}, six).aUnIntervalle);
        Mesure cinq = new Mesure(new double[] {1, 1, 1, 1, 1}, Arrays.copyOf(six, 5));
        assertTrue(!cinq.aUnIntervalle);
        assertEquals("erreur de 2.41, sans intervalle : l'image est trop petite", cinq.enMots());
        assertEquals("aucun écart sur 6 pixels", new Mesure(new double[] {1, 1, 1, 1, 1, 1}, new double[6]).enMots());
    }
}
