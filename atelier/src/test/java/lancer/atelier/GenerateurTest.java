package lancer.atelier;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Locale;
import lancer.Camera;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.lecture.LecteurScene;
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
        ByteArrayOutputStream erreurs = new ByteArrayOutputStream();
        int statut = Generateur.executer(args, texte, new PrintStream(erreurs, true, "UTF-8"));
        assertEquals("", erreurs.toString("UTF-8"));
        assertEquals(0, statut);
        return texte.toString();
    }

    private Scene lire(String... args) throws IOException {
        Path fichier = dossier.resolve("scene.ini");
        Files.write(fichier, engendrer(args).getBytes(StandardCharsets.UTF_8));
        LecteurScene lu = LecteurScene.lire(fichier.toString());
        assertEquals(2, lu.getLampes().size());
        assertTrue(lu.getAvertissements().isEmpty());
        return new Scene(lu);
    }

    @ParameterizedTest(name = "foule {0}")
    @ValueSource(ints = {1, 2, 10, 500, 1331})
    void lesBoulesDeLaFouleNeSeTouchentPas(int n) throws IOException {
        Scene scene = lire("foule", Integer.toString(n));
        assertEquals(n, scene.getObjets().size());
        verifierSepares(scene, 0);
        verifierVisible(scene, 0);
    }

    @ParameterizedTest(name = "tournesol {0}")
    @ValueSource(ints = {1, 2, 10, 34, 100, 1000, 3000})
    void lesBoulesDuTournesolNeSeTouchentPas(int n) throws IOException {
        Scene scene = lire("tournesol", Integer.toString(n));
        assertEquals(n + 1, scene.getObjets().size(), "les boules, et le sol");
        verifierSepares(scene, 1);
        verifierVisible(scene, 1);
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
        "foule 100000001", "foule 5 1", "tournesol dix", "tournesol 0", "tournesol 5 1", "foule 99999999999999999999"})
    void uneDemandeFautiveTientEnUneLigne(String ligne) throws IOException {
        String[] args = ligne.isEmpty() ? new String[0] : ligne.split(" ");
        StringBuilder texte = new StringBuilder();
        ByteArrayOutputStream erreurs = new ByteArrayOutputStream();
        assertEquals(2, Generateur.executer(args, texte, new PrintStream(erreurs, true, "UTF-8")));
        assertEquals("", texte.toString());
        String message = erreurs.toString("UTF-8").trim();
        assertTrue(message.startsWith("Generateur : ") && message.contains("usage : "), message);
        assertEquals(1, message.split("\\R").length, message);
    }

    @Test
    void appeleDeJavaUnNombreHorsLimitesEstRefuseAvantDEcrire() {
        StringBuilder texte = new StringBuilder();
        assertThrows(IllegalArgumentException.class, () -> Generateur.foule(texte, 0));
        assertThrows(IllegalArgumentException.class, () -> Generateur.tournesol(texte, -1));
        assertEquals("", texte.toString());
    }

    private static void verifierSepares(Scene scene, int premiere) {
        for (int i = premiere; i < scene.getObjets().size(); i++) {
            for (int j = premiere; j < i; j++) {
                assertTrue(ecart(scene, i, j) > 0, "boules " + i + " et " + j + " : écart " + ecart(scene, i, j));
            }
        }
    }

    /** Chaque boule est devant l'écran, et son centre dans une image de 800 × 600. */
    private static void verifierVisible(Scene scene, int premiere) {
        for (int i = premiere; i < scene.getObjets().size(); i++) {
            Point c = sphere(scene, i).getCentre();
            double recul = (c.z + Camera.FOCALE) / Camera.FOCALE;
            assertTrue(c.z - sphere(scene, i).getRayon() > 0 && Math.abs(c.x) < recul && Math.abs(c.y) < 0.75 * recul, "boule " + i);
        }
    }

    /** De surface à surface, négatif si elles se coupent. */
    private static double ecart(Scene scene, int i, int j) {
        Sphere a = sphere(scene, i);
        Sphere b = sphere(scene, j);
        return b.getCentre().sub(a.getCentre()).norme() - a.getRayon() - b.getRayon();
    }

    private static Sphere sphere(Scene scene, int i) {
        Objet3D objet = scene.getObjets().get(i);
        return (Sphere) objet;
    }
}
