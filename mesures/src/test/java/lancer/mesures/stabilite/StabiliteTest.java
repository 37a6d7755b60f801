package lancer.mesures.stabilite;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les courbes de stabilité et des méthodes. */
class StabiliteTest {

    private static final Path RESULTATS = Paths.get(Files.exists(Paths.get("mesures")) ? "mesures/resultats" : "resultats");

    @TempDir
    Path dossier;

    @Test
    void refaitesLesCourbesSontLesMemesAuBitPresEtSeDessinentSansEcran() throws IOException {
        Path deuxieme = Files.createDirectory(dossier.resolve("deux"));
        Stabilite.mesurer(dossier, true);
        Stabilite.mesurer(deuxieme, true);
        assertArrayEquals(Files.readAllBytes(dossier.resolve(Stabilite.CSV)), Files.readAllBytes(deuxieme.resolve(Stabilite.CSV)));
        Stabilite.dessiner(dossier);
        for (String nom : new String[] {"loin", "ras", "sol", "defauts", "petites", "reflets"}) {
            BufferedImage planche = ImageIO.read(dossier.resolve("stabilite-" + nom + ".png").toFile());
            assertEquals(1600, planche.getWidth(), nom);
        }
        Bilan bilan = new Bilan(Exactitude.lire(dossier.resolve(Stabilite.CSV), Exactitude.STABILITE));
        // ce que la page promet et raconte, sur ces rayons-ci aussi
        assertTrue(bilan.unites(Mesures.LOIN) <= Cas.K && bilan.unites(Mesures.RAS) <= Cas.K
                && bilan.unites(Mesures.RAS_LOIN) <= Cas.K);
        assertEquals(0, bilan.faux(Mesures.LOIN, Aspect.PROGRAMME, Bilan.DE_LOIN));
        assertEquals(0, bilan.faux(Mesures.DEFAUTS, Aspect.PROGRAMME, 0));
        assertTrue(bilan.faux(Mesures.LOIN, Aspect.MANUEL, Bilan.DE_LOIN) > 100, "de loin, le manuel ne sait plus qui touche");
        assertTrue(bilan.pente() > 0.8 && bilan.pente() < 1.2, "pente " + bilan.pente());
        bilan.defauts().forEach(r -> assertTrue(r.faux > 0, r.formule + " se voit"));
        petitesBoules(bilan);
        reflets(bilan);
    }

    private static void petitesBoules(Bilan bilan) {
        for (String methode : new String[] {"un_rayon", "coins", "grille"}) {
            bilan.de(PetitesBoules.FIGURE, methode).stream().filter(r -> r.erreurRelative > 0)
                    .forEach(r -> assertEquals(1, r.y / r.erreurRelative, 0.15, methode + " à " + r.x + " : la forme close"));
        }
        Exactitude partage = bilan.de(PetitesBoules.FIGURE, "partage").get(1);
        Exactitude grille = bilan.de(PetitesBoules.FIGURE, "grille").get(1);
        assertTrue(partage.x < 0.5 && partage.y < 1.1 * grille.y && partage.erreurEnUnites < grille.erreurEnUnites / 5);
        assertTrue(bilan.de(PetitesBoules.FIGURE, PetitesBoules.SANS).get(1).y > 2 * partage.y, "s'il ne sait pas où elles sont");
    }

    private static void reflets(Bilan bilan) {
        for (Exactitude r : bilan.de(Reflets.FIGURE, "double")) {
            double compensee = bilan.de(Reflets.FIGURE, "compensee").get((int) r.x - 1).erreurRelative;
            assertTrue(r.x > 5 ? r.x < 15 || r.erreurRelative == 1 : r.erreurRelative < 1e-6, r.x + " reflets : " + r.erreurRelative);
            assertTrue(Math.abs(Math.log10(compensee / r.erreurRelative)) < 1.5, "un reflet sans erreur ne garde pas un chiffre de plus");
        }
        assertTrue(bilan.de(Reflets.FIGURE, "deux_doubles").get(14).erreurRelative < 1e-6, "quinze reflets, deux doubles");
        assertEquals(1, bilan.de(Reflets.FIGURE, "float").get(7).erreurRelative, "huit reflets, en float");
    }

    /** Sans les temps, qui sont de la machine. */
    private static String comptes(Exactitude r) {
        return r.figure + " " + r.formule + " " + r.essais + " " + r.faux + " " + r.erreurRelative + " " + r.erreurEnUnites;
    }

    private static List<String> comptes(List<Exactitude> exactitudes) {
        return exactitudes.stream().map(StabiliteTest::comptes).collect(Collectors.toList());
    }

    @Test
    void lesComptesNotesSontCeuxDuProgrammeDeCeCommit() throws IOException {
        List<Exactitude> notees = Exactitude.lire(RESULTATS.resolve(Stabilite.CSV), Exactitude.STABILITE);
        assertEquals(comptes(Mesures.defauts()),
                comptes(notees.stream().filter(r -> r.figure.equals(Mesures.DEFAUTS)).collect(Collectors.toList())));
        List<String> sol = comptes(notees.stream().filter(r -> r.figure.equals(Mesures.SOL)).collect(Collectors.toList()));
        assertEquals(comptes(new Mesures(false).sol()), sol, "make mesures MESURES=--stabilite");
        double dite = Double.parseDouble(new Bilan(notees).nombres().get("stabilite.ras.unites").replace(',', '.'));
        assertTrue(notees.stream().filter(r -> r.figure.startsWith(Mesures.RAS) && r.formule.equals("programme"))
                .allMatch(r -> r.erreurEnUnites <= dite), "au plus " + dite + " : un arrondi ne doit pas le rendre faux");
    }

    @Test
    void lesErreursDesMethodesSontCellesNoteesEtLeProgrammeEstLeSeulDesRapidesQuiTienneSaBorne() throws IOException {
        List<Exactitude> notees = Exactitude.lire(RESULTATS.resolve(Methodes.CSV), Exactitude.METHODES);
        assertTrue(notees.stream().allMatch(r -> r.formule.equals("float") || r.y <= 0.15 * r.x), "make noyaux, la machine tranquille");
        Map<String, Exactitude> juges = new TreeMap<>();
        for (Regime regime : Regime.values()) {
            List<Exactitude> siennes = regime.juger();
            assertEquals(comptes(siennes), comptes(notees.stream().filter(r -> r.figure.equals(regime.cle())).collect(Collectors.toList())),
                    "make noyaux");
            siennes.forEach(r -> juges.put(Methodes.cle(r.figure, r.formule), r));
            Exactitude programme = juges.get(Methodes.cle(regime.name(), "programme"));
            assertEquals(0, programme.faux, regime.name());
            assertTrue(programme.erreurEnUnites <= Cas.K, regime + " : " + programme.erreurEnUnites);
            Exactitude fin = juges.get(Methodes.cle(regime.name(), "deux_doubles"));
            assertTrue(fin.faux == 0 && fin.erreurEnUnites <= Cas.K, regime + " : " + fin.erreurEnUnites);
        }
        assertTrue(juges.get("loin manuel").part() > 0.05, "de loin, le manuel ne sait plus qui touche");
        assertTrue(juges.get("sol perpendiculaire").erreurEnUnites > 100 * Cas.K, "sur un sol, l'arrondi de P − C");
        assertTrue(juges.get("loin compensee").erreurEnUnites > 100 * Cas.K, "b² − c perd de loin ce que la perpendiculaire garde");
    }

    @Test
    void desTempsDePlusNeChangentQueLesTempsEtLaCourbeSeDessine() throws IOException {
        Map<String, double[]> temps = new TreeMap<>();
        for (Regime regime : Regime.values()) {
            for (Aspect methode : Aspect.values()) {
                temps.put(Methodes.cle(regime.name(), methode.cle()), new double[] {5 + methode.ordinal(), 0.5});
            }
        }
        Methodes.noter(dossier, temps);
        Methodes methodes = new Methodes(dossier);
        methodes.planche().ecrire(dossier.resolve("methodes.png"));
        assertEquals(1600, ImageIO.read(dossier.resolve("methodes.png").toFile()).getWidth());
        assertEquals("× 1,7", methodes.pages().get("methodes.programme.loin"), "12 ns contre 7");
        temps.values().forEach(t -> t[1] = 4);
        Methodes.noter(dossier, temps);
        assertEquals("autant, à l'intervalle près", new Methodes(dossier).pages().get("methodes.programme.loin"), "12 ± 4 ns contre 7 ± 4");
    }
}
