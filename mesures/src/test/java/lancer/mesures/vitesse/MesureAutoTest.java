package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import lancer.Scene;
import lancer.atelier.FichierCsv;
import lancer.atelier.SceneAuHasard;
import lancer.mesures.Gabarit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce qui juge {@code --auto}. */
class MesureAutoTest {

    @TempDir
    Path dossier;

    @Test
    void laPromesseDUneSceneSimpleEstTenueEtDecrite() throws IOException {
        Scene scene = SceneAuHasard.de(3);
        Taille taille = new Taille(56, 42);
        String ligne = MesureAuto.ligne("sort-3", scene, taille, new Gabarit(scene, taille.largeur, taille.hauteur, 1), 8);
        List<Map<String, String>> lue = FichierCsv.lire(Files.write(dossier.resolve("auto.csv"),
                Arrays.asList(MesureAuto.COLONNES, ligne), StandardCharsets.UTF_8));
        Map<String, String> promesse = lue.get(0);
        assertEquals("oui oui", promesse.get("promise") + " " + promesse.get("tenue"), ligne);
        assertTrue(promesse.get("reglage").startsWith("[Antialias] n="), ligne);
        assertEquals("1 fois sur 1", Rapport.promesses(lue).get("auto.sort"));
        // une image de 56 × 42 n'a pas droit à la moitié de son dessin, mais à ce que rien ne demande en 0,2 s
        assertTrue(Double.parseDouble(promesse.get("rayons_des_essais")) * taille.pixels() < 550_000, ligne);
    }
}
