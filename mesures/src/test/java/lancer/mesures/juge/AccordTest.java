package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.WritableRaster;
import java.util.Arrays;
import java.util.Collections;
import lancer.Couleur;
import org.junit.jupiter.api.Test;

/** L'accord de deux images. */
class AccordTest {

    private final float[] nous = ScenesJugees.couleurs(ScenesJugees.deuxBoules(new Couleur(0.5)));
    private final WritableRaster lui = ScenesJugees.image(nous);

    private Accord accord(WritableRaster... images) {
        return new Accord(ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, nous, images);
    }

    private void decaler(WritableRaster image, int x, int y, int composante, int niveaux) {
        int niveau = image.getSample(x, y, composante);
        image.setSample(x, y, composante, niveau > 32767 ? niveau - niveaux : niveau + niveaux);
    }

    @Test
    void uneImageNeSEcarteDElleMemeQueDeSonArrondi() {
        Accord accord = accord(lui);
        assertEquals(0, accord.auDela8);
        assertEquals(Collections.emptyList(), accord.auDela16);
        assertEquals(0, accord.pire, 0.5 * 255 / 65535 + 1e-12);
    }

    @Test
    void lesPixelsAuDelaDUnPasSontComptesUneFoisChacun() {
        // un pas de 8 bits vaut 257 niveaux de 16 bits ; l'arrondi, un demi-niveau au plus
        decaler(lui, 3, 2, 0, 258);
        decaler(lui, 3, 2, 1, 300);
        decaler(lui, 7, 20, 2, 256);
        decaler(lui, 9, 20, 2, 2);
        Accord accord = accord(lui);
        assertEquals(1, accord.auDela8);
        assertEquals(Arrays.asList(2 * ScenesJugees.LARGEUR + 3, 20 * ScenesJugees.LARGEUR + 7, 20 * ScenesJugees.LARGEUR + 9),
                accord.auDela16);
        assertEquals(300 / 257.0, accord.pire, 0.5 / 257 + 1e-12);
    }

    @Test
    void lEcartMoyenEstQuadratique() {
        Arrays.fill(nous, 0.5f);
        for (int c = 0; c < 3; c++) {
            for (int y = 0; y < ScenesJugees.HAUTEUR; y++) {
                for (int x = 0; x < ScenesJugees.LARGEUR; x++) {
                    lui.setSample(x, y, c, (int) (0.5 * 65535 + (c == 0 ? 2 * 257 : 0)));
                }
            }
        }
        assertEquals(Math.sqrt(2.0 * 2 / 3), accord(lui).moyen, 0.003);
    }

    @Test
    void lesCouleursAuDelaDuBlancEtDuNoirSontLimitees() {
        Arrays.fill(nous, 7);
        nous[0] = -1;
        WritableRaster blanc = ScenesJugees.image(nous);
        assertEquals(0, accord(blanc).pire);
        assertEquals(65535, blanc.getSample(1, 0, 0));
        assertEquals(0, blanc.getSample(0, 0, 0));
    }

    @Test
    void deTroisImagesChacuneNeVautQuePourSaComposante() {
        WritableRaster[] trois = {ScenesJugees.image(nous), ScenesJugees.image(nous), ScenesJugees.image(nous)};
        decaler(trois[0], 5, 5, 1, 9999);
        decaler(trois[2], 6, 6, 0, 9999);
        assertEquals(0, accord(trois).auDela8);
        decaler(trois[1], 5, 5, 1, 9999);
        assertEquals(1, accord(trois).auDela8);
    }
}
