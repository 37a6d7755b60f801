package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.dessin.Dessin;
import lancer.essai.Essai;
import lancer.image.ImageMemoire;
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
        float[] programme = Essai.dessiner(dossier, SCENE, "--taille=64x48", simple ? "--simple" : "--fils=2");
        ImageMemoire image = new ImageMemoire(64, 48, true);
        Scene scene = new Scene(SCENE.toString());
        Lancer lancer = Dessin.lancer(scene, 64, 48, simple);
        assertTrue(!simple || scene.getModele().getRecherche() == null, "ce sont les boucles du cours");
        lancer.TracerPixels(image, Constantes.MAX_REFLETS, 2);
        for (int k = 0; k < programme.length; k++) {
            // un fichier PFM commence par la ligne du bas
            assertEquals(programme[(47 - k / 192) * 192 + k % 192], image.lineaire[k], "pixel " + k / 3);
        }
    }
}
