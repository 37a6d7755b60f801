package lancer.atelier;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.scene.LecteurScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Les scènes engendrées. */
class GenerateurTest {

    @TempDir
    Path dossier;

    private static String engendrer(String... args) throws IOException {
        StringBuilder texte = new StringBuilder();
        Generateur.ecrire(texte, args);
        return texte.toString();
    }

    private Scene lire(String... args) throws IOException {
        Path fichier = dossier.resolve("scene.ini");
        Files.write(fichier, engendrer(args).getBytes(StandardCharsets.UTF_8));
        LecteurScene lu = new LecteurScene().lire(fichier.toString());
        assertEquals(2, lu.lampes.size());
        assertTrue(lu.avertissements.isEmpty());
        return new Scene(lu.objets, lu.lampes);
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"foule 1", "foule 2", "foule 10", "foule 500", "foule 1331", "tournesol 1", "tournesol 2", "tournesol 10",
        "tournesol 34", "tournesol 100", "tournesol 1000", "tournesol 3000"})
    void lesBoulesDevantLOeilNeSeTouchentPas(String ligne) throws IOException {
        String[] args = ligne.split(" ");
        List<Sphere> spheres = lire(args).getObjets().stream().map(Sphere.class::cast).collect(Collectors.toList());
        // la première du tournesol est le sol
        List<Sphere> boules = spheres.subList(args[0].equals("foule") ? 0 : 1, spheres.size());
        assertEquals(Integer.parseInt(args[1]), boules.size());
        for (Sphere a : boules) {
            for (Sphere b : boules) {
                double ecart = b.getCentre().sub(a.getCentre()).norme() - a.getRayon() - b.getRayon();
                assertTrue(a == b || ecart > 0, () -> a + " et " + b + " : écart " + ecart);
            }
            // devant l'écran, et son centre dans une image de 800 × 600
            Point c = a.getCentre();
            double recul = (c.z + Camera.FOCALE) / Camera.FOCALE;
            assertTrue(c.z - a.getRayon() > 0 && Math.abs(c.x) < recul && Math.abs(c.y) < 0.75 * recul, () -> "boule " + a);
        }
    }

    @Test
    void laLangueDeLaMachineNeChangeRienAuTexte() throws IOException {
        Locale avant = Locale.getDefault();
        String texte = engendrer("tournesol", "50");
        try {
            Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
            assertEquals(texte, engendrer("tournesol", "50"));
            Locale.setDefault(Locale.FRANCE);
            assertEquals(texte, engendrer("tournesol", "50"));
        } finally {
            Locale.setDefault(avant);
        }
    }

    @Test
    void leTournesolLivreEstCeluiDuGenerateur() throws IOException {
        Path ici = Paths.get("scenes", "tournesol.ini");
        Path fichier = Files.exists(ici) ? ici : Paths.get("..").resolve(ici);
        String texte = new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
        assertEquals(engendrer("tournesol", "1000"), texte.replace("\r\n", "\n"));
    }

    @ParameterizedTest(name = "« {0} » est refusé")
    @ValueSource(strings = {"", "neige 3", "foule", "foule -1", "foule 1.5", "foule 0",
        "foule 100000001", "foule 5 1", "tournesol dix", "tournesol 0", "tournesol -1", "tournesol 5 1", "foule 99999999999999999999"})
    void uneDemandeFautiveTientEnUneLigneEtNEcritRien(String ligne) {
        String[] args = ligne.isEmpty() ? new String[0] : ligne.split(" ");
        StringBuilder texte = new StringBuilder();
        String message = assertThrows(IllegalArgumentException.class, () -> Generateur.ecrire(texte, args)).getMessage();
        assertEquals("", texte.toString());
        assertTrue(message.contains("nombre de boules") && !message.contains("\n"), message);
    }

    @Test
    void uneSceneAuHasardNeDependQueDeSaGraine() {
        assertEquals(SceneAuHasard.de(7).getObjets().toString(), SceneAuHasard.de(7).getObjets().toString());
        assertNotEquals(SceneAuHasard.de(7).getObjets().toString(), SceneAuHasard.de(8).getObjets().toString());
    }
}
