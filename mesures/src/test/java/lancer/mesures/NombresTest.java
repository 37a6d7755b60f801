package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les nombres des pages, ceux des fichiers, et ce qui se sait d'un nombre mesuré. */
class NombresTest {

    @Test
    void lesNombresSontALaFrancaiseSansChiffreDeTrop() {
        assertEquals("0", Nombres.nombre(0));
        assertEquals("0,5", Nombres.nombre(0.5));
        assertEquals("12,3", Nombres.nombre(12.345));
        assertEquals("1\u00A0000\u00A0000", Nombres.nombre(1e6));
        assertEquals("0,001", Nombres.nombre(0.001));
        assertEquals("\u22123", Nombres.nombre(-3));
        assertEquals("2,1", Nombres.arrondi(2.08));
        assertEquals("0,022", Nombres.arrondi(0.02151));
        assertEquals("24", Nombres.arrondi(23.7));
        assertEquals("1", Nombres.arrondi(0.999));
        assertEquals("0,83 niveau", Nombres.niveaux(0.832));
        assertEquals("1,9 niveau", Nombres.niveaux(1.94));
        assertEquals("2 niveaux", Nombres.niveaux(1.96));
    }

    @Test
    void dixNeufFoisSurVingtLErreurJusteEstDansLIntervalle() {
        Random hasard = new Random(2);
        // un pixel sur dix a une erreur de 10, les autres aucune
        long dedans = Stream.generate(() -> Intervalle.deLaRacine(hasard.doubles(2000).map(x -> x < 0.1 ? 100 : 0).toArray())).limit(2000)
                .filter(i -> i.min <= Math.sqrt(10) && i.max >= Math.sqrt(10)).count();
        assertEquals(0.95, dedans / 2000.0, 0.015);
        assertEquals(2, Intervalle.mediane(4, 1, 1, 4), 1e-12);
    }

    @Test
    void unFichierEstLuCommeIlEstEcritEtRefuseSIlNEstPasRegulier(@TempDir Path dossier) throws IOException {
        Path csv = dossier.resolve("a.csv");
        assertEquals(0, FichierCsv.lire(csv).size());
        Files.write(csv, List.of("nom,x", FichierCsv.ligne("partage n=8", Nombres.champ(0.5)), FichierCsv.ligne("", "")));
        assertEquals("[partage n=8, 0.50000]", Arrays.toString(FichierCsv.lire(csv).get(0)));
        assertEquals(Double.NaN, Nombres.champ(FichierCsv.lire(csv).get(1)[1]));
        Files.write(csv, List.of("nom,x", "seul"));
        assertThrows(IOException.class, () -> FichierCsv.lire(csv));
        assertThrows(IllegalArgumentException.class, () -> FichierCsv.ligne("a,b"));
    }
}
