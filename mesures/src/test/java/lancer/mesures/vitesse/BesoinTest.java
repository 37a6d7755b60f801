package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Map;
import lancer.mesures.FichierCsv;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce que demande une scène. */
class BesoinTest {

    private static final Taille TAILLE = new Taille(80, 60);

    @TempDir
    Path dossier;

    private Besoin besoin(String texte) throws IOException {
        Path fichier = dossier.resolve("essai.ini");
        Files.write(fichier, texte.getBytes(StandardCharsets.UTF_8));
        return new Besoin(fichier, TAILLE);
    }

    private Map<String, String> champs(Besoin besoin) throws IOException {
        Path csv = dossier.resolve("besoins.csv");
        Files.write(csv, (String.join(",", Besoin.COLONNES) + "\n" + besoin.ligne() + "\n").getBytes(StandardCharsets.UTF_8));
        return FichierCsv.lire(csv).get(0);
    }

    @Test
    void uneBouleMateNeDemandeAucunReflet() throws IOException {
        Besoin mate = besoin("[Sphere 1]\ncentre=0 0 4\nrayon=0.5\nKd=1 1 1\n[Lampe 1]\nposition=-4 6 -3\ncouleur=1 1 1\n");
        assertEquals(0, mate.profondeurUtile());
    }

    @Test
    void uneBouleBrillanteSeuleNEnDemandeQuUnCeluiDuCiel() throws IOException {
        assertEquals(1, besoin("[Sphere 1]\ncentre=0 0 4\nrayon=0.5\nKs=0.5 0.5 0.5\n").profondeurUtile());
    }

    @Test
    void deuxMiroirsEnDemandentPlusQueLeProgrammeNEnFait() {
        assertTrue(new Besoin(Paths.get("scenes/miroirs.ini"), TAILLE).profondeurUtile() > 20);
    }

    @Test
    void lesRayonsSontCeuxQueLOnCompteALaMain() throws IOException {
        // une boule qui couvre toute l'image, et une lampe derrière elle
        Besoin besoin = besoin("[Sphere 1]\ncentre=0 0 100\nrayon=90\nKd=1 1 1\n[Lampe 1]\nposition=0 0 -50\ncouleur=1 1 1\n"
                + "[Lampe derrière]\nposition=0 0 300\ncouleur=1 1 1\n");
        int pixels = TAILLE.pixels();
        assertEquals(String.valueOf(2 * pixels), champs(besoin).get("rayons"), "le primaire, et l'ombre de la lampe de devant");
    }
}
