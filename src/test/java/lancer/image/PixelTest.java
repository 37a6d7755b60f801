package lancer.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import lancer.Camera;
import lancer.Scene;
import lancer.contrat.Modele;
import lancer.essai.Essai;
import lancer.essai.EssaiCommande;
import lancer.essai.EssaiPixel;
import lancer.essai.Ressources;
import lancer.inspection.Inspection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code --pixel} : un pixel dessiné seul est celui de l'image, et se dit en une ligne. */
class PixelTest extends EssaiCommande {

    @ParameterizedTest
    @CsvSource({"p1-quatre, 61, 47, --reflets=5", "p2-sol, 70, 33, --seuil=0", "p3-miroirs, 40, 30, --reflets=40",
        "p4-foule, 33, 65, --reflets=0", "p4-foule, 1, 1, --seuil=0.2", "p1-quatre, 100, 3, --simple"})
    void lePixelDemandeEstCeluiDeLImage(String scene, int largeur, int hauteur, String option) throws IOException {
        EssaiPixel.verifier(List.of(), dossier, Path.of(Ressources.chemin("reference/" + scene + ".ini")), largeur, hauteur,
                option);
    }

    @Test
    void ilNeCouteQueSonRayonPourSaCouleurPuisPourSaChaine() {
        int[] rayons = new int[1];
        Modele.Construction modele = new Modele.Construction();
        modele.setAtmosphere((vue, distance) -> {
            rayons[0]++;
            return vue;
        });
        Scene vide = new Scene(List.of(), List.of()).avec(modele.construire());
        new Inspection(vide, chose -> null, new Camera(40, 70), 5, 31, 31).faire(() -> false);
        assertEquals(2, rayons[0]);
    }

    @Test
    void milleReflexionsNeDebordentPasLaPileDeCeluiQuiDemande() throws Exception {
        // deux miroirs l'un dans l'autre
        Path scene = Essai.scene(dossier.resolve("s.ini"), "[Sphere 1]", "centre=0.1 0.2 0", "rayon=50", "Ks=1 1 1", "[Sphere 2]",
                "centre=0 0 0", "rayon=60", "Ks=1 1 1", "[Lampe 1]", "position=0 55 0", "couleur=1 1 1");
        Essai image = Essai.executer("--reflets=1000", "--seuil=0", "--taille=1x1", "--statistiques", "--image=" + png, scene.toString());
        assertEquals(1000, image.statistique("rayons.reflechis"));
        String[] options = {"--reflets=1000", "--seuil=0", "--taille=9x7", scene.toString(), "--pixel=2,3"};
        Essai[] essai = new Essai[1];
        Thread petite = new Thread(null, () -> essai[0] = Essai.executer(options), "petite pile", 1 << 17);
        petite.start();
        petite.join();
        assertEquals(0, essai[0].code, essai[0].toString());
        EssaiPixel.verifier(List.of(), dossier, scene, 9, 7, "--reflets=1000", "--seuil=0");
    }

    @Test
    void laLigneEstEnUtf8QuelleQueSoitLaConsole() throws IOException {
        ByteArrayOutputStream sortie = new ByteArrayOutputStream();
        PrintStream console = new PrintStream(sortie, true, "UTF-16");
        assertEquals(0, Essai.executer(console, System.err, "--pixel=1,1", SCENE));
        String ligne = new String(sortie.toByteArray(), StandardCharsets.UTF_8);
        assertTrue(ligne.matches("(?s).*\\Rsomme [0-9.E-]+ [0-9.E-]+ [0-9.E-]+ = #[0-9A-F]{6}\\R"), ligne);
    }
}
