package lancer.mesures.stabilite;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import lancer.Point;
import lancer.mesures.trace.Planche;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les courbes de stabilité. */
class StabiliteTest {

    private static final Path RESULTATS = Path.of(Files.exists(Path.of("mesures")) ? "mesures/resultats" : "resultats");

    @TempDir
    Path dossier;

    @Test
    void lesCourbesSeDessinentSansEcranEtDisentCeQueLaPageRaconte() throws IOException {
        new Mesures(true).ecrire(dossier);
        for (Map.Entry<String, Planche> figure : Figures.planches(dossier).entrySet()) {
            figure.getValue().ecrire(dossier.resolve(figure.getKey()));
            assertTrue(figure.getValue().seVoit(), figure.getKey());
        }
        for (String nom : new String[] {"loin", "ras", "sol", "reflets"}) {
            BufferedImage planche = ImageIO.read(dossier.resolve("stabilite-" + nom + ".png").toFile());
            assertEquals(1600, planche.getWidth(), nom);
        }
        Bilan bilan = new Bilan(dossier);
        // ce que la page promet et raconte, sur ces rayons-ci aussi
        for (String figure : new String[] {Mesures.LOIN, Mesures.RAS, Mesures.RAS_LOIN, Mesures.SOL, Mesures.POSE}) {
            assertTrue(bilan.max(figure, r -> Bilan.estClasse(r) ? r.erreurEnUnites : 0) <= Bilan.PROMESSE, figure);
        }
        assertEquals(0, faux(bilan, Formule.PROGRAMME));
        assertTrue(faux(bilan, Formule.MANUEL) > 100, "de loin, le manuel ne sait plus qui touche");
        double[] manuel = bilan.de(Mesures.LOIN, Formule.MANUEL).stream().filter(r -> r.x > 9 && r.x < 2e6)
                .mapToDouble(r -> r.erreurEnUnites).toArray();
        double pente = Math.log10(manuel[manuel.length - 1] / manuel[0]) / 5;
        assertTrue(pente > 0.8 && pente < 1.2, "pente " + pente);
        reflets(bilan);
    }

    /** Les rayons mal classés, de dix rayons de la sphère ou plus. */
    private static int faux(Bilan bilan, Formule methode) {
        return bilan.de(Mesures.LOIN, methode).stream().filter(r -> r.x >= 10).mapToInt(r -> r.faux).sum();
    }

    private static void reflets(Bilan bilan) {
        for (Exactitude r : bilan.de(Reflets.FIGURE, "double")) {
            double compensee = bilan.de(Reflets.FIGURE, "compensee").get((int) r.x - 1).erreurRelative;
            assertTrue(r.x > 5 ? r.x < 15 || r.erreurRelative == 1 : r.erreurRelative < 1e-6, r.x + " reflets : " + r.erreurRelative);
            assertTrue(Math.abs(Math.log10(compensee / r.erreurRelative)) < 1.5, "un reflet sans erreur ne garde pas un chiffre de plus");
        }
        assertTrue(bilan.de(Reflets.FIGURE, "deux_doubles").get(14).erreurRelative < 1e-6, "quinze reflets, deux doubles");
        assertEquals(1, bilan.de(Reflets.FIGURE, "float").get(7).erreurRelative, "huit reflets, en float");
        // deux rayons voisins s'écartent de 2d/r par reflet, où d est au hasard de 5 à 40, de logarithme uniforme, et r = 1
        assertEquals(Math.log(2 * Math.sqrt(5 * 40)), bilan.exposantDeLyapunov(), 0.2);
    }

    /** Sans les temps, qui sont de la machine. */
    private static String comptes(List<Exactitude> exactitudes) {
        return exactitudes.stream().map(r -> r.figure + " " + r.formule + " " + r.essais + " " + r.faux + " " + r.erreurRelative + " "
                + r.erreurEnUnites).collect(Collectors.joining("\n"));
    }

    @Test
    void lesComptesNotesSontCeuxDuProgrammeDeCeCommit() throws IOException {
        List<Exactitude> notees = Exactitude.lire(RESULTATS.resolve(Mesures.CSV));
        String sol = comptes(notees.stream().filter(r -> r.figure.equals(Mesures.SOL)).collect(Collectors.toList()));
        assertEquals(comptes(new Mesures(false).sol()), sol, "make mesures MESURES=--stabilite");
    }

    @Test
    void laReponseExacteEstCelleDesTrianglesRectangles() {
        // de l'origine vers z, une boule de rayon 5 à la distance 3 de l'axe, centrée à 20 : h = 4
        Cas cas = new Cas(new Point(), new Point(0, 0, 7), new Point(0, 3, 20), 5);
        assertEquals(16, cas.distance);
        assertEquals(24, new Cas(new Point(0, 0, 18), new Point(0, 0, 19), new Point(0, 3, 20), 5).distance + 18, "du dedans, la sortie");
        assertEquals(Double.POSITIVE_INFINITY, new Cas(new Point(), new Point(0, 0, 1), new Point(0, 6, 20), 5).distance, "à côté");
        assertEquals(Double.POSITIVE_INFINITY, new Cas(new Point(), new Point(0, 0, -1), new Point(0, 3, 20), 5).distance, "derrière");
        assertEquals(0x1p-40, new Cas(new Point(), new Point(0, 0, 1), new Point(0, 0, 1 + 0x1p-40), 1).distance);
    }
}
