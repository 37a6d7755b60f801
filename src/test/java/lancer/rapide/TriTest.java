package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

@DisplayName("Le tri par base")
class TriTest {

    @Test
    @DisplayName("range comme celui de Java des clés dont les moitiés basses croissent, mêmes ou extrêmes")
    void memeOrdreQueJava() {
        Random hasard = new Random(14);
        for (int tour = 0; tour < 200; tour++) {
            long[] cles = new long[hasard.nextInt(300)];
            int bits = 1 + hasard.nextInt(31);
            for (int k = 0; k < cles.length; k++) {
                cles[k] = (long) (hasard.nextInt() >>> 32 - bits) << 32 | k;
            }
            long[] attendues = cles.clone();
            Arrays.sort(attendues);
            assertArrayEquals(attendues, Tri.parMoitieHaute(cles), tour + " : " + cles.length + " clés de " + bits + " bits");
        }
    }
}
