package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.dessin.Dessin;
import lancer.essai.Essai;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Une scène préparée à la main est celle que dessine la ligne de commande : qui mesure l'une mesure l'autre. */
class PreparerTest {

    private static final Path SCENE = Paths.get("scenes", "scene1.ini");

    @TempDir
    Path dossier;

    @ParameterizedTest(name = "simple : {0}")
    @ValueSource(booleans = {false, true})
    void preparerEstCeQueFaitLeProgramme(boolean simple) throws IOException {
        String taille = "--taille=64x48";
        float[] programme = simple ? Essai.dessiner(dossier, SCENE, taille, "--simple") : Essai.dessiner(dossier, SCENE, taille);
        ImageMemoire image = new ImageMemoire(64, 48, true);
        Scene scene = new Scene(SCENE.toString());
        Dessin.lancer(scene, 64, 48, simple).TracerPixels(image, Constantes.MAX_REFLETS, 2);
        float[] preparee = image.lineaire;
        for (int j = 0; j < 48; j++) {
            // un fichier PFM commence par la ligne du bas
            float[] ligne = new float[3 * 64];
            System.arraycopy(programme, (47 - j) * 3 * 64, ligne, 0, 3 * 64);
            float[] sienne = new float[3 * 64];
            System.arraycopy(preparee, j * 3 * 64, sienne, 0, 3 * 64);
            assertArrayEquals(ligne, sienne, "ligne " + j);
        }
    }

    @Test
    void simpleDonneLesBouclesDuCours() {
        Scene scene = new Scene(SCENE.toString());
        Lancer lancer = Dessin.lancer(scene, 64, 48, true);
        assertNull(scene.getModele().getRecherche());
        assertEquals(64, lancer.getCamera().getLargeur());
        assertEquals(48, lancer.getCamera().getHauteur());
    }
}
