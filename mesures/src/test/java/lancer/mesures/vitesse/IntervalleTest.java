package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.Stream;
import lancer.mesures.Intervalle;
import org.junit.jupiter.api.Test;

/** Ce qui se sait d'un nombre mesuré. */
class IntervalleTest {

    private static void assertDedans(double part, double juste, Supplier<Intervalle> mesure) {
        assertEquals(part, Stream.generate(mesure).limit(2000).filter(i -> i.min <= juste && i.max >= juste).count() / 2000.0, 0.015);
    }

    @Test
    void dixNeufFoisSurVingtLeRapportJusteEstDansLIntervalle() {
        Random hasard = new Random(1);
        // la loi binomiale dit 96,9 % pour 6 rapports, 96,1 pour 9, 95,9 pour 20
        for (int n : new int[] {6, 9, 20}) {
            assertDedans(n == 6 ? 0.969 : 0.96, 2,
                    () -> Intervalle.desRapports(hasard.doubles(n).map(x -> 2 * Math.exp(0.1 * hasard.nextGaussian())).toArray()));
        }
    }

    @Test
    void dUneSeuleMancheRienNeSeDit() {
        Intervalle un = Intervalle.desRapports(100);
        assertEquals(100, un.valeur, 1e-9);
        assertFalse(new Intervalle(1, 1, 1).nettementSous(un) || un.nettementSous(new Intervalle(1e6, 1e6, 1e6)));
    }

    @Test
    void dixNeufFoisSurVingtLErreurJusteEstDansLIntervalle() {
        Random hasard = new Random(2);
        // un pixel sur dix a une erreur de 10, les autres aucune
        assertDedans(0.95, Math.sqrt(10),
                () -> Intervalle.deLaRacine(hasard.doubles(2000).map(x -> x < 0.1 ? 100 : 0).toArray()));
    }

    @Test
    void deuxIntervallesQuiSeTouchentNeFontPasUneDifference() {
        Intervalle petit = new Intervalle(1, 0.9, 1.1);
        assertTrue(petit.nettementSous(new Intervalle(1.3, 1.2, 1.4)));
        assertFalse(petit.nettementSous(new Intervalle(1.3, 1.1, 1.5)));
        assertEquals(2, Intervalle.mediane(4, 1, 1, 4), 1e-12);
        assertEquals("autant, à l'intervalle près (de 0,9 à 1,1)", Tableaux.rapport(petit));
        assertEquals("× 3 (de 2 à 4)", Tableaux.rapport(new Intervalle(3, 2, 4)));
    }
}
