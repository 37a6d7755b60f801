package lancer.mesures.stabilite;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import lancer.Point;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les courbes de stabilité. */
class StabiliteTest {

    private static final Point ORIGINE = new Point();

    @TempDir
    Path dossier;

    @Test
    void leJugeEstUnCalculSansArrondiQueLesFormesClosesConfirment() {
        // de face, de dedans, de dos, une tangente exacte, un départ sur la surface qui sort, puis qui entre
        juge(4, 1, new Exacte(ORIGINE, new Point(0, 0, 1), new Point(0, 0, 5), 1));
        juge(2, 2, new Exacte(ORIGINE, new Point(0, 0, 3), ORIGINE, 2));
        assertEquals(Double.POSITIVE_INFINITY, new Exacte(ORIGINE, new Point(0, 0, -1), new Point(0, 0, 5), 1).distance);
        juge(5, 0, new Exacte(ORIGINE, new Point(0, 0, 7), new Point(3, 0, 5), 3));
        assertEquals(Double.POSITIVE_INFINITY, new Exacte(new Point(0, 0, 1), new Point(0, 0, 2), ORIGINE, 1).distance);
        juge(2, 1, new Exacte(new Point(0, 0, 1), ORIGINE, ORIGINE, 1));
        // h² = 0,75, et le triangle 3, 4, 5 : les deux réponses ont une racine
        juge(2 - Math.sqrt(0.75), Math.sqrt(0.75), new Exacte(new Point(0, 0.5, -2), new Point(0, 0.5, 0), ORIGINE, 1));
        juge(25 - Math.sqrt(7), Math.sqrt(7), new Exacte(ORIGINE, new Point(3, 4, 0), new Point(15 - 2.4, 20 + 1.8, 0), 4), 4e-15);
        // au-dessus d'un sol de 2^60, à hauteur 2^-20 : c/(b + h) à l'aplomb est cette hauteur, que les doubles perdent
        juge(0x1p-20, 0x1p60, new Exacte(new Point(0, 0x1p-20, 0), new Point(0, -1, 0), new Point(0, -0x1p60, 0), 0x1p60));
        assertEquals(-2, new Exacte(ORIGINE, new Point(0, 0, 1), new Point(3, 0, 5), 1).enfoncement);
    }

    private static void juge(double distance, double demiCorde, Exacte exacte) {
        juge(distance, demiCorde, exacte, 1e-15);
    }

    private static void juge(double distance, double demiCorde, Exacte exacte, double relative) {
        assertEquals(distance, exacte.distance, relative * distance);
        assertEquals(demiCorde, exacte.demiCorde, relative * demiCorde);
    }

    @Test
    void lesRacinesOntSoixanteDixChiffres() {
        Random hasard = new Random(6);
        for (int k = 0; k < 2_000; k++) {
            BigDecimal x = new BigDecimal(hasard.nextDouble() * Math.pow(10, 40 * hasard.nextDouble() - 20));
            BigDecimal s = Exacte.racine(x);
            double ecart = s.multiply(s).subtract(x).abs().doubleValue() / x.doubleValue();
            assertTrue(ecart < 1e-70, "graine 6, tirage " + k + " : " + ecart);
        }
        assertEquals(0, Exacte.racine(BigDecimal.valueOf(144)).compareTo(BigDecimal.valueOf(12)));
        assertEquals(BigDecimal.ZERO, Exacte.racine(new BigDecimal("0.00")));
    }

    @Test
    void refaitesLesCourbesSontLesMemesAuBitPresEtSeDessinentSansEcran() throws IOException {
        Path deuxieme = Files.createDirectory(dossier.resolve("deux"));
        Stabilite.mesurer(dossier, true);
        Stabilite.mesurer(deuxieme, true);
        assertArrayEquals(Files.readAllBytes(dossier.resolve(Stabilite.CSV)), Files.readAllBytes(deuxieme.resolve(Stabilite.CSV)));
        Stabilite.dessiner(dossier);
        for (String nom : Stabilite.PLANCHES) {
            BufferedImage planche = ImageIO.read(dossier.resolve(nom + ".png").toFile());
            assertEquals(1600, planche.getWidth(), nom);
        }
        Bilan bilan = new Bilan(Exactitude.lire(dossier.resolve(Stabilite.CSV)));
        // ce que la page promet et raconte, sur ces rayons-ci aussi
        assertTrue(bilan.unites(Mesures.LOIN) <= Cas.K && bilan.unites(Mesures.RAS) <= Cas.K
                && bilan.unites(Mesures.RAS_LOIN) <= Cas.K);
        assertEquals(0, bilan.fauxDeLoin(Formule.PROGRAMME));
        assertEquals(0, bilan.faux(Formule.PROGRAMME, Mesures.CARTE));
        assertEquals(0, bilan.faux(Formule.PROGRAMME, Defauts.FIGURE));
        assertTrue(bilan.faux(Formule.MANUEL, Mesures.CARTE) > bilan.essais(Formule.MANUEL, Mesures.CARTE) / 10);
        assertTrue(bilan.pente() > 0.8 && bilan.pente() < 1.2, "pente " + bilan.pente());
        bilan.defauts(false).forEach(r -> assertTrue(r.faux > 0, r.formule + " se voit"));
    }

    @Test
    void unAutreFichierNEstPasLuCommeDesCourbes() throws IOException {
        Path autre = dossier.resolve("autre.csv");
        Files.write(autre, java.util.Arrays.asList("scene,famille", "a,b"));
        assertThrows(IOException.class, () -> Exactitude.lire(autre));
        List<Exactitude> une = Collections.singletonList(new Exactitude("loin", "manuel", 0.1, 1e-14, 3, 1, 1e-300, Double.MAX_VALUE));
        Exactitude.ecrire(autre, une);
        Exactitude relue = Exactitude.lire(autre).get(0);
        assertEquals(0.1, relue.x);
        assertEquals(1e-300, relue.erreurRelative);
        assertEquals(1.0 / 3, relue.part());
    }
}
