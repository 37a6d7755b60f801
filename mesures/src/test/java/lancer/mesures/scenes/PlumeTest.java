package lancer.mesures.scenes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** Les nombres et les couleurs écrits. */
class PlumeTest {

    @Test
    void unNombreSEcritANeufDecimalesSansZerosDeFin() throws IOException {
        StringBuilder texte = new StringBuilder();
        Plume plume = new Plume(texte);
        plume.sphere("essai", -0.5, 1e-9, 20000, 0.123456789, "");
        plume.sphere("1", -1e-10, 3, 0.1 + 0.2, 1e-3, "");
        assertEquals("\n[Sphere essai]\ncentre=-0.5 0.000000001 20000\nrayon=0.123456789\n"
                + "\n[Sphere 1]\ncentre=0 3 0.3\nrayon=0.001\n", texte.toString());
        assertThrows(IllegalArgumentException.class, () -> plume.sphere("nul", Double.NaN, 0, 0, 1, ""));
    }

    @Test
    void lesTeintesFontLeTourDesCouleurs() {
        assertArrayEquals(new double[] {1, 0, 0}, Plume.couleur(0, 1, 1));
        assertArrayEquals(new double[] {1, 1, 0}, Plume.couleur(1 / 6.0, 1, 1));
        assertArrayEquals(new double[] {0, 0.5, 0}, Plume.couleur(1 / 3.0, 1, 0.5));
        assertArrayEquals(new double[] {0, 0, 1}, Plume.couleur(-1 / 3.0, 1, 1));
        assertArrayEquals(new double[] {0.8, 0.4, 0.4}, Plume.couleur(1, 0.5, 0.8));
    }
}
