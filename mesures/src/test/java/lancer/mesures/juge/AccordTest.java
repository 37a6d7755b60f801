package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import lancer.mesures.ImageLineaire;
import org.junit.jupiter.api.Test;

/** L'accord de deux images. */
class AccordTest {

    private static final double PAS_16 = 1 / 65535.0;

    private final ImageLineaire nous = new ImageLineaire(100, 50);
    private final ImageLineaire lui = new ImageLineaire(100, 50);

    private void decaler(int pixel, int composante, double pas16) {
        lui.getComposantes()[3 * pixel + composante] += pas16 * PAS_16;
    }

    @Test
    void lesPixelsAuDelaDUnPasSontComptesUneFoisChacun() {
        // un pas de 8 bits en vaut 257 de 16
        decaler(203, 0, 258);
        decaler(203, 1, 300);
        decaler(2007, 2, 256);
        decaler(2009, 2, 0.9);
        Juge.Accord accord = new Juge.Accord(nous, lui);
        assertEquals(1, accord.auDela8);
        assertEquals(2, accord.auDela16);
        assertEquals(300 / 257.0, accord.pire, 1e-9);
        assertEquals(203, accord.pirePixel);
        assertFalse(accord.estLa());
    }

    @Test
    void ilTientAUnPixelSurMilleDePlusDUnPasDe16Bits() {
        for (int k = 0; k < 5; k++) {
            decaler(k, 0, 40);
        }
        assertTrue(new Juge.Accord(nous, lui).estLa());
        decaler(5, 2, 40);
        assertFalse(new Juge.Accord(nous, lui).estLa());
    }
}
