package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import lancer.Camera;
import lancer.Point;
import lancer.Vecteur;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** La caméra d'une section, telle que le programme entier l'emploie. */
class CameraLueTest {

    private static final String BOULE = "[Sphere devant]\ncentre=0 0 6\nrayon=1\n[Sphere derrière]\ncentre=0 0 9\nrayon=1\n";

    @TempDir
    Path dossier;

    private Camera lire(String... section) throws IOException {
        Path scene = Essai.scene(dossier.resolve("s.ini"), String.join("\n", section), BOULE);
        return LecteurScene.lire(scene.toString(), part -> { }).getCadrage().apply(80, 60);
    }

    @Test
    void laSectionPlaceLOeilLeTourneEtOuvreSonChamp() throws IOException {
        Camera camera = lire("[CAMERA de côté]", "Cible=4 1 -3", "champ=90", "OEIL=1 2 3");
        assertEquals(new Point(1, 2, 3), camera.getOeil());
        assertEquals(0, camera.getRayon(40, 30).getV().sub(new Vecteur(3, -1, -6).normalized()).norme(), 1e-15);
        assertEquals(0, camera.getRayon(0, 30).getV().dot(camera.getRayon(80, 30).getV()), 1e-15);
        Point cible = camera.projeter(new Point(4, 1, -3));
        assertEquals(40, cible.x, 1e-12);
        assertEquals(30, cible.y, 1e-12);
    }

    @Test
    void sansOeilNiCibleSeulLeChampChange() throws IOException {
        Camera camera = lire("[Camera]", "champ=90");
        assertEquals(-1, camera.getOeil().z, 1e-15);
        assertEquals(0, camera.getEcran(12, 34).z, 1e-15);
        assertEquals(camera.getX(12), camera.getEcran(12, 34).x);
        assertEquals(Camera.class, lire("; aucune section").getClass());
    }

    @Test
    void leRecitDUnPixelEstVuDeCetOeil() throws IOException {
        lire("[Camera]", "oeil=0 0 20", "cible=0 0 6");
        String scene = dossier.resolve("s.ini").toString();
        Essai recit = Essai.executer("--pixel=40,30", "--taille=80x60", scene);
        assertTrue(recit.sortie.contains("[Sphere derrière]") && !recit.sortie.contains("1  [Sphere devant]"), recit.sortie);
    }
}
