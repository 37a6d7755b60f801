package lancer.mesures.noyaux;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import lancer.essai.Formule;
import lancer.mesures.stabilite.Methodes;
import lancer.mesures.stabilite.Regime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openjdk.jmh.runner.options.CommandLineOptions;

/** Les noyaux. */
class NoyauxTest {

    static {
        // ces tests ne jugent aucun temps : une mesure faite ailleurs sur la machine ne doit pas les empêcher
        System.setProperty("jmh.ignoreLock", "true");
    }

    @TempDir
    Path dossier;

    @Test
    void jmhLesMesureTousEtNiDesTempsTropLargesNiUnePartieDesMethodesNeSontEcrits() throws Exception {
        ByteArrayOutputStream sortie = new ByteArrayOutputStream();
        PrintStream ecran = new PrintStream(sortie, true, "UTF-8");
        Map<String, double[]> temps = Noyaux.mesurer(new CommandLineOptions("-f", "0", "-wi", "0", "-i", "2", "-r", "2ms"), ecran);
        assertEquals(Formule.values().length * Regime.values().length, temps.size());
        assertTrue(sortie.toString("UTF-8").matches("(?s).*\nPROGRAMME +SOL +[0-9.]+ +± [0-9.?]+ +ns.*"), sortie.toString("UTF-8"));
        temps.values().forEach(t -> t[1] = 0);
        temps.get("sol manuel")[1] = 0.2 * temps.get("sol manuel")[0];
        assertFalse(Noyaux.noter(temps, dossier, ecran));
        assertTrue(sortie.toString("UTF-8").contains("n'est pas tranquille"));
        assertFalse(Files.exists(dossier.resolve(Methodes.CSV)));
        temps.get("sol manuel")[1] = 0;
        temps.get("sol float")[1] = Double.NaN;
        assertFalse(Noyaux.noter(temps, dossier.resolve("absent"), ecran));
        assertTrue(sortie.toString("UTF-8").contains("À lancer à la racine"));
        temps.remove("sol manuel");
        assertTrue(Noyaux.noter(temps, dossier, ecran), "c'est ce qui était demandé");
        assertTrue(sortie.toString("UTF-8").contains("Toutes les méthodes n'ont pas été mesurées"));
        assertFalse(Files.exists(dossier.resolve(Methodes.CSV)));
    }

    @Test
    void uneMethodeQuiSeTrompeNEstPasMesuree() {
        for (Formule formule : Formule.values()) {
            NoyauMethode.verifier(formule, Regime.ORDINAIRE);
        }
        IllegalStateException refus = assertThrows(IllegalStateException.class, () -> NoyauMethode.verifier(Formule.FLOAT, Regime.LOIN));
        assertTrue(refus.getMessage().contains("aucun temps"), refus.getMessage());
    }

    @Test
    void leNoyauSommeLesPlusPetitesDistancesDeSonRegimeTrancheesOuNon() {
        double programme = noyau(Formule.PROGRAMME);
        double moyenne = programme * NoyauMethode.ENSEMBLE / NoyauMethode.RAYONS;
        assertTrue(moyenne > 0.5 && moyenne < 2, "un œil à hauteur 1 : " + moyenne);
        assertEquals(programme, noyau(Formule.DEUX_DOUBLES), 1e-11);
        assertEquals(programme, noyau(Formule.RECHERCHE), "un doute qui n'est pas tranché n'était pas le plus proche");
    }

    private static double noyau(Formule formule) {
        NoyauMethode noyau = new NoyauMethode();
        noyau.formule = formule;
        noyau.regime = Regime.SOL;
        noyau.tirer();
        return noyau.distance();
    }
}
