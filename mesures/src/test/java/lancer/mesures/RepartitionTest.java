package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** La répartition des temps. */
class RepartitionTest {

    @ParameterizedTest(name = "{0} : quartiles {1}, {2}, {3}")
    @CsvSource({"7, 7, 7, 7", "1 2, 1.25, 1.5, 1.75", "3 1 2, 1.5, 2, 2.5", "4 1 3 2, 1.75, 2.5, 3.25", "50 10 40 20 30, 20, 30, 40",
        "1 1 1 1000, 1, 1, 250.75"})
    void lesQuartilesSontExacts(String temps, double q1, double mediane, double q3) {
        String[] mots = temps.split(" ");
        long[] nombres = new long[mots.length];
        for (int k = 0; k < mots.length; k++) {
            nombres[k] = Long.parseLong(mots[k]);
        }
        Repartition repartition = new Repartition(nombres);
        assertEquals(mots.length, repartition.nombre());
        assertEquals(q1, repartition.premierQuartile());
        assertEquals(mediane, repartition.mediane());
        assertEquals(q3, repartition.troisiemeQuartile());
    }

    @Test
    void lesTempsDonnesNeSontPasDeranges() {
        long[] temps = {3, 1, 2};
        Repartition repartition = new Repartition(temps);
        assertEquals(3, temps[0]);
        assertEquals(1, repartition.min());
        assertEquals(3, repartition.max());
    }

    @Test
    void sansTempsPasDeRepartition() {
        assertThrows(IllegalArgumentException.class, Repartition::new);
    }
}
