package lancer.fenetre;

import static lancer.fenetre.BancFenetre.pixelsSansFenetre;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import lancer.fenetre.BancFenetre.MainLent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Une fenêtre du programme sur un vrai écran, et une petite scène à lui donner. */
@Tag("fenetre")
@ExtendWith(UnSeulEcran.class)
@Timeout(120)
abstract class EssaiFenetre {

    static final int L = 320;
    static final int H = 240;
    static final String TAILLE = "--taille=" + L + "x" + H;
    static final String ROUGE = "[Sphere 1]\ncentre=0 0.2 6\nrayon=1\nKd=0.9 0.15 0.1\nKs=0.3 0.3 0.3\nns=40\n"
            + "[Sphere 2]\ncentre=-1.2 -0.6 5\nrayon=0.5\nKd=0.1 0.6 0.2\nKs=0.2 0.2 0.2\nns=10\n"
            + "[Lampe 1]\nposition=-4 6 -3\ncouleur=0.9 0.9 0.85\n";
    static final String BLEUE = ROUGE.replace("0.9 0.15 0.1", "0.1 0.2 0.9");
    static final String FAUTIVE = ROUGE.replace("rayon=1\n", "rayon=-1\n");

    @TempDir
    Path dossier;
    Path scene;
    BancFenetre banc;

    @BeforeEach
    void ecrireLaScene() throws Exception {
        scene = dossier.resolve("boule.ini");
        ecrire(ROUGE);
    }

    @AfterEach
    void fermer() throws Exception {
        if (banc != null) {
            banc.fermer();
        }
    }

    void ecrire(String texte) throws Exception {
        Files.write(scene, texte.getBytes(StandardCharsets.UTF_8));
    }

    MainLent lente(String... options) {
        String[] args = Arrays.copyOf(options, options.length + 2);
        args[options.length] = TAILLE;
        args[options.length + 1] = scene.toString();
        return new MainLent(args);
    }

    int[] attendue(int largeur, int hauteur) throws Exception {
        return pixelsSansFenetre(dossier, scene, largeur, hauteur);
    }
}
