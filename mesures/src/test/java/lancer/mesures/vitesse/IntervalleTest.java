package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;

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
    void dixNeufFoisSurVingtLErreurJusteEstDansLIntervalle() {
        Random hasard = new Random(2);
        // un pixel sur dix a une erreur de 10, les autres aucune
        assertDedans(0.95, Math.sqrt(10),
                () -> Intervalle.deLaRacine(hasard.doubles(2000).map(x -> x < 0.1 ? 100 : 0).toArray()));
    }

    @Test
    void unTempsNEstDitPlusLongQuAuDelaDUnDixieme() {
        assertEquals(2, Intervalle.mediane(4, 1, 1, 4), 1e-12);
        assertEquals("autant, à un dixième près", Tableaux.rapport(0.92));
        assertEquals("× 3", Tableaux.rapport(3));
    }
}
