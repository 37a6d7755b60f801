package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Objet3D;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.essai.Essai;
import lancer.essai.EssaiProcessus;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Une scène que la machine ne sait pas lire jusqu'au bout, ou qui change pendant qu'on la lit : une ligne, et pas d'image. */
@Timeout(120)
class EchecsLectureTest extends EssaiProcessus {

    @Test
    void uneLectureQuiEchoueSeDitEnUneLigne() {
        Path memoire = Path.of("/proc/self/mem");
        assumeTrue(Files.exists(memoire), "il faut un fichier qu'on ouvre et qui ne se lit pas");
        Essai e = Essai.executer("--image=" + dossier.resolve("a.png"), memoire.toString());
        assertEquals(2, e.code, e.toString());
        assertTrue(e.erreur.matches("lancer : /proc/self/mem, ligne 1 : lecture impossible \\(.+\\) ; attendu : un fichier de scène\n"),
                e.toString());
        verifierDossier();
    }

    @Test
    void unTubeFermeAMiCheminDonneUneSceneTronqueeQuiEstRefusee() throws Exception {
        supposerUnix();
        Path tube = dossier.resolve("flux/tube");
        assumeTrue(new ProcessBuilder("mkfifo", tube.toString()).start().waitFor() == 0, "pas de tubes ici");
        Process ecrivain = new ProcessBuilder("/bin/sh", "-c", "printf '[Sphere 1]\\ncentre=0 0 6\\nray' > " + tube).start();
        Essai e = Essai.executer("--image=" + dossier.resolve("a.png"), tube.toString());
        ecrivain.waitFor();
        assertEquals("lancer : " + tube + ", ligne 3, [Sphere 1] : ligne illisible : « ray » ; attendu : clé=valeur, [Section], ou un "
                + "commentaire seul sur sa ligne, après ; ou #" + System.lineSeparator(), e.erreur);
        assertEquals(2, e.code);
        verifierDossier();
    }

    /** Réécrite en place, effacée et remise pendant qu'on la lit : une scène entière ou tronquée, ou une ligne ; rien d'autre. */
    @Test
    void uneSceneQuiChangeOuDisparaitPendantQuOnLaLitNeDonnePasAutreChose() throws Exception {
        // un rayon d'un seul chiffre : coupé, il ne se lit plus, au lieu de se lire autre
        byte[] scene = IntStream.range(0, 3000).mapToObj(k -> "[Sphere " + k + "]\ncentre=" + k + " 0 6\nrayon=5\n")
                .collect(Collectors.joining()).getBytes(StandardCharsets.UTF_8);
        Path fichier = Files.write(dossier.resolve("s.ini"), scene);
        AtomicBoolean fini = new AtomicBoolean();
        Thread editeur = new Thread(() -> {
            try {
                for (int k = 0; !fini.get(); k++) {
                    if (k % 3 == 0) {
                        Files.deleteIfExists(fichier);
                    }
                    Files.write(fichier, k % 2 == 0 ? scene : Arrays.copyOf(scene, scene.length - 12 * (k % 1000)));
                }
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
        });
        editeur.start();
        try {
            for (int k = 0; k < 300; k++) {
                try {
                    for (Objet3D objet : new Scene(fichier.toString()).getObjets()) {
                        assertEquals(5, ((Sphere) objet).getRayon());
                    }
                } catch (SceneFautive e) {
                    assertTrue(e.getMessage().matches("\\Q" + fichier + "\\E(, ligne .+)? : [^\\p{Cntrl}]+ ; attendu : [^\\p{Cntrl}]+"),
                            e.getMessage());
                }
            }
        } finally {
            fini.set(true);
            editeur.join();
        }
    }

    @Test
    void unFichierSansFinEstRefuseAvecPeuDeMemoire() throws Exception {
        assumeTrue(Files.exists(Path.of("/dev/zero")), "pas de /dev/zero ici");
        assertEquals(2, statut(preparer(java("-Xmx48m", "--image=a.png", "/dev/zero"))), erreur());
        assertEquals("lancer : /dev/zero, ligne 1 : lecture impossible (ligne de plus de 8 Mo) ; attendu : un fichier de scène\n",
                erreur());
        verifierDossier();
    }
}
