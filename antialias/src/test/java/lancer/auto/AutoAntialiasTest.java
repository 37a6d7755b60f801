package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.dessin.Dessin;
import lancer.essai.Essai;
import lancer.scene.SectionLue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code --auto} quand l'anticrénelage est là. */
class AutoAntialiasTest {

    private static final List<Path> SEULE = List.of(Essai.origine(Antialias.class));

    @TempDir
    Path dossier;
    private Path scene;

    @BeforeEach
    void ecrireLaScene() throws IOException {
        scene = dossier.resolve("scene.ini");
        Files.write(scene, Essai.octets(Antialias.class, "/reference/p1-quatre.ini"));
    }

    /** Les lignes du rapport, sans ce qui les commence. */
    private static Map<String, String> rapport(Essai essai) {
        assertEquals(0, essai.code, essai.toString());
        Map<String, String> lignes = new LinkedHashMap<>();
        for (String ligne : essai.erreur.split("\r?\n")) {
            assertTrue(ligne.matches("lancer : auto, (choisi|mesuré) : .*"), ligne);
            String[] moities = ligne.substring("lancer : auto, ".length()).split(" : ", 2);
            lignes.put(moities[0], moities[1]);
        }
        assertEquals("[choisi, mesuré]", lignes.keySet().toString());
        return lignes;
    }

    /** L'échelle de la variante, en entier, sur une image petite : l'erreur de chaque échelon est celle de son image. */
    @Test
    void lErreurDeChaqueEchelonEstCelleDeSonImage() {
        Scene lue = new Scene(scene.toString());
        // sans la brume, que ce chemin des classes y installe
        Lancer prepare = Dessin.lancer(new Scene(lue.getObjets(), lue.getLampes()), 80, 50, false);
        List<Reglages> echelle = Echelle.de(Options.lire().pour(
                Map.of(new Antialias(), new SectionLue("Antialias"))), false, false);
        assertEquals(10, echelle.size());
        Echantillon tires = new Echantillon(prepare, 2, rang -> new Couleur(), 0.125, Long.MAX_VALUE, Integer.MAX_VALUE,
                new SplittableRandom(1));
        Couleur[] image = new Couleur[80 * 50];
        double avant = Double.POSITIVE_INFINITY;
        long rayons = 0;
        for (Reglages echelon : echelle) {
            Mesure essai = tires.essayer(echelon);
            Lancer lancer = prepare.avec(echelon.getModele());
            lancer.TracerImage((couleur, i, j) -> image[j * 80 + i] = couleur, echelon.getProfondeur(), 2);
            assertEquals(tires.mesurer(rang -> image[rang]).erreur, essai.erreur, echelon.toString());
            assertTrue(essai.plus(-1) <= avant, echelon + " : " + essai.erreur + " après " + avant);
            assertTrue(lancer.getAtelier().getCompteurs().rayons() > rayons, echelon.toString());
            avant = essai.plus(1);
            rayons = lancer.getAtelier().getCompteurs().rayons();
        }
        assertTrue(avant < 1, "" + avant);
    }

    @Test
    void leChoixSeRefaitALaMain() throws IOException {
        Essai essai = Essai.executerAvec(SEULE, "--taille=120x90", "--lineaire=" + dossier.resolve("auto.pfm"), "--auto=erreur=1",
                scene.toString());
        String choisi = rapport(essai).get("choisi");
        assertTrue(choisi.matches("\\[Antialias\\] n=\\d+ methode=\\w+ seuil=[0-9.]+, --reflets \\d+ --seuil [0-9.]+"), choisi);
        String[] moities = choisi.split(", ");
        Files.writeString(scene, "\n" + moities[0].replace(" ", "\n") + "\n", StandardOpenOption.APPEND);
        float[] alamain = Essai.dessinerAvec(SEULE, dossier, scene, Essai.suite(moities[1].split(" "), "--taille=120x90"));
        assertArrayEquals(alamain, Essai.pfm(Files.readAllBytes(dossier.resolve("auto.pfm"))));
    }

    @Test
    void laSectionDeLaSceneEstRespectee() throws IOException {
        Files.writeString(scene, "\n[Antialias]\nn=2\nseuil=0\n", StandardOpenOption.APPEND);
        Essai essai = Essai.executerAvec(SEULE, "--taille=120x90", "--auto=erreur=0.01", "--statistiques",
                "--lineaire=" + dossier.resolve("auto.pfm"), scene.toString());
        Map<String, String> rapport = rapport(essai);
        assertTrue(rapport.get("choisi").startsWith("l'échantillonnage de la scène, --reflets "), rapport.toString());
        assertEquals(4 * 120 * 90, essai.statistique("rayons.primaires"));
    }
}
