package lancer.mesures.scenes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Scene;
import lancer.Sphere;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Les foules, et les scènes au hasard. */
class FouleTest {

    @TempDir
    Path dossier;

    private static String engendrer(int n) throws IOException {
        StringBuilder texte = new StringBuilder();
        Foule.ecrire(texte, n);
        return texte.toString();
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(ints = {1, 2, 10, 500, 1331})
    void lesBoulesDevantLOeilNeSeTouchentPas(int n) throws IOException {
        Path fichier = Files.writeString(dossier.resolve("scene.ini"), engendrer(n));
        SceneLue lu = LecteurScene.lire(fichier.toString(), part -> { });
        assertEquals(2, lu.lampes.size());
        assertTrue(lu.avertissements.isEmpty());
        List<Sphere> boules = lu.objets.stream().map(Sphere.class::cast).collect(Collectors.toList());
        assertEquals(n, boules.size());
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
        String texte = engendrer(50);
        try {
            Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
            assertEquals(texte, engendrer(50));
            Locale.setDefault(Locale.FRANCE);
            assertEquals(texte, engendrer(50));
        } finally {
            Locale.setDefault(avant);
        }
    }

    @ParameterizedTest(name = "« {0} » est refusé")
    @ValueSource(strings = {"", "dix", "-1", "1.5", "0", "100000001", "5 1", "99999999999999999999"})
    void uneDemandeFautiveTientEnUneLigne(String ligne) {
        String message = assertThrows(IllegalArgumentException.class, () -> Foule.combien(ligne.split(" "))).getMessage();
        assertTrue(message.contains("nombre de boules") && !message.contains("\n"), message);
    }

    private static boolean estUnGrain(Objet3D objet) {
        return ((Sphere) objet).getRayon() < 0.1;
    }

    @Tag("long")
    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"poussiere", "ombres-fines", "poussiere-miroirs"})
    void uneSceneDifficileADesDetailsPlusPetitsQuUnPixelVusOuSeulementDevines(String nom) throws IOException {
        Path fichier = Scenes.fichier(nom, dossier);
        byte[] octets = Files.readAllBytes(fichier);
        Scene scene = Scenes.lire(fichier);
        long grains = scene.getObjets().stream().filter(FouleTest::estUnGrain).count();
        assertTrue(grains > 1000, grains + " grains");
        // un pixel sur seize d'une image ordinaire, ou sur soixante-quatre
        int pas = System.getProperty("tests.longs") != null ? 4 : 8;
        Camera camera = new Camera(800, 600);
        long vus = IntStream.range(0, 800 / pas * (600 / pas)).filter(k -> {
            PointContact contact = scene.getClosestIntersection(camera.getRayon(k % (800 / pas) * pas + 0.5, k / (800 / pas) * pas + 0.5));
            return contact != null && estUnGrain(contact.objet);
        }).count();
        // au plus un pixel par grain : il est plus petit ; des deux autres scènes, l'ombre et le reflet seuls se voient
        assertTrue(nom.equals("poussiere") ? vus > 0 && pas * pas * vus < grains : vus == 0, vus + " pixels de grains");
        assertArrayEquals(octets, Files.readAllBytes(Scenes.fichier(nom, dossier)), "toujours la même");
    }
}
