package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** L'observation du fichier d'une scène : sa date et sa taille disent qu'il a changé, une fois qu'il ne change plus. */
@Timeout(60)
class SurveillanceTest {

    @TempDir
    Path dossier;
    private final LinkedBlockingQueue<String> dits = new LinkedBlockingQueue<>();
    private final Surveillance veille = new Surveillance(20, () -> dits.add("change"), () -> dits.add("efface"));
    private Path fichier;

    @BeforeEach
    void suivreUnFichier() throws IOException {
        fichier = dossier.resolve("s.ini");
        ecrire("un", 1);
        veille.suivre(fichier.toString(), FichierScene.version(fichier.toString()));
    }

    @AfterEach
    void terminer() {
        veille.terminer();
    }

    private void ecrire(String texte, int date) throws IOException {
        // d'un coup : de deux versions, deux seraient annoncées
        Path neuf = Files.write(dossier.resolve("neuf"), texte.getBytes());
        Files.setLastModifiedTime(neuf, FileTime.from(date, TimeUnit.HOURS));
        Files.move(neuf, fichier, StandardCopyOption.ATOMIC_MOVE);
    }

    private void attendre(String attendu) throws InterruptedException {
        assertEquals(attendu, dits.poll(40, TimeUnit.SECONDS));
        assertNull(dits.poll(200, TimeUnit.MILLISECONDS), "cela ne se dit qu'une fois");
    }

    @Test
    void uneAutreDateOuUneAutreTailleSeDisentUneFois() throws Exception {
        ecrire("un", 2);
        attendre("change");
        ecrire("trois", 2);
        attendre("change");
    }

    @Test
    void unFichierEffaceSeDitPuisSonRetour() throws Exception {
        Files.delete(fichier);
        attendre("efface");
        ecrire("un", 1);
        attendre("change");
    }

    @Test
    void unFichierQuiNEstPlusSuiviNeDitPlusRien() throws Exception {
        Path autre = Files.write(dossier.resolve("autre.ini"), "deux".getBytes());
        veille.suivre(autre.toString(), FichierScene.version(autre.toString()));
        ecrire("un", 2);
        Files.delete(fichier);
        assertNull(dits.poll(400, TimeUnit.MILLISECONDS));
        Files.delete(autre);
        attendre("efface");
    }
}
