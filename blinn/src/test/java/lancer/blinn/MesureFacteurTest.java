package lancer.blinn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Ce que la mesure doit retrouver : 4 dans le plan d'incidence, 4·cos²i en travers, quand le reflet est petit. */
class MesureFacteurTest {

    private static final double NS = 1e5;

    @ParameterizedTest
    @ValueSource(doubles = {0, 15, 30, 45, 60, 75})
    void unPetitRefletSuitLaFormeClose(double i) {
        double cos2 = Math.pow(Math.cos(Math.toRadians(i)), 2);
        assertEquals(4, MesureFacteur.ligne(NS, i, 0).meilleur(), 2e-3);
        assertEquals(4 * cos2, MesureFacteur.ligne(NS, i, 90).meilleur(), 2e-3);
        assertEquals(2 * (1 + cos2), MesureFacteur.ligne(NS, i, 45).meilleur(), 2e-3);
    }

    @Test
    void deFaceLesDeuxRefletsSeConfondent() {
        assertEquals(4, MesureFacteur.entier(NS, 0).meilleur(), 2e-3);
        assertTrue(MesureFacteur.entier(NS, 0).ecart(4) < 1e-4);
    }

    @Test
    void leTableauDuReadmeEstCeluiDeLaMesure() throws IOException {
        String readme = new String(Files.readAllBytes(Paths.get("README.md")), StandardCharsets.UTF_8);
        assertTrue(readme.contains(MesureFacteur.tableau()), () -> "à recopier dans README.md :\n" + MesureFacteur.tableau());
    }
}
