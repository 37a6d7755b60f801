package lancer.cours;

import java.io.IOException;
import java.nio.file.Path;
import lancer.essai.Essai;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Les images de référence, calculées à part en quadruple précision, sans seuil. */
@Tag("reference")
class ImagesDeReferenceTest {

    @TempDir
    Path dossier;

    @ParameterizedTest(name = "{0}, {2} réflexions")
    @CsvSource({
        "p1-quatre, p1-quatre, 5",
        "p2-sol, p2-sol, 5",
        "p3-miroirs, p3-miroirs, 5",
        "p3-miroirs, p3-miroirs.reflets-0, 0",
        "p3-miroirs, p3-miroirs.reflets-12, 12",
        "p4-foule, p4-foule, 5"})
    void laBaseDonneLImageDeReference(String scene, String image, String reflets) throws IOException {
        Essai.dessiner(dossier, Path.of(Ressources.chemin("reference/" + scene + ".ini")),
                "--taille", "120x90", "--seuil", "0", "--reflets", reflets);
        Essai.verifierReference(image + ".pfm", dossier);
    }
}
