package lancer;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Les images de référence, calculées à part en quadruple précision, sans seuil. */
class ImagesTest {

    /** Ce que l'arrondi de la double précision peut changer, et ce que les flottants du fichier peuvent perdre. */
    private static final double TOLERANCE = 1e-6;

    @ParameterizedTest(name = "{0}, {2} réflexions")
    @CsvSource({
        "p1-quatre, p1-quatre, 5",
        "p2-sol, p2-sol, 5",
        "p3-miroirs, p3-miroirs, 5",
        "p3-miroirs, p3-miroirs.reflets-0, 0",
        "p3-miroirs, p3-miroirs.reflets-12, 12",
        "p4-foule, p4-foule, 5"})
    void laBaseDonneLImageDeReference(String scene, String image, int reflets) {
        Ressources.Image attendue = Ressources.pfm("reference/" + image + ".pfm");
        Scene lue = new Scene(Ressources.chemin("reference/" + scene + ".ini"));
        lue.setSeuil(0);
        Ressources.Image obtenue = new Ressources.Image(attendue.largeur, attendue.hauteur);
        new Lancer(lue, new Camera(attendue.largeur, attendue.hauteur)).TracerPixels(obtenue, reflets, 2);
        double ecart = obtenue.ecart(attendue);
        assertTrue(ecart <= TOLERANCE, "écart " + ecart);
    }
}
