package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertNotNull;
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
    private final LinkedBlockingQueue<Boolean> dits = new LinkedBlockingQueue<>();
    private final Surveillance veille = new Surveillance(() -> dits.add(true));
    private Path fichier;

    @BeforeEach
    void suivreUnFichier() throws IOException {
        fichier = dossier.resolve("s.ini");
        ecrire("un", 1);
        veille.suivre(fichier.toString(), Surveillance.version(fichier.toString()));
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

    private void attendre(String quoi) throws InterruptedException {
        assertNotNull(dits.poll(40, TimeUnit.SECONDS), quoi);
        assertNull(dits.poll(800, TimeUnit.MILLISECONDS), "cela ne se dit qu'une fois");
    }

    @Test
    void uneAutreDateOuUneAutreTailleSeDisentUneFois() throws Exception {
        ecrire("un", 2);
        attendre("une autre date");
        ecrire("trois", 2);
        attendre("une autre taille");
    }

    @Test
    void unFichierEffaceSeDitPuisSonRetour() throws Exception {
        Files.delete(fichier);
        attendre("effacé");
        ecrire("un", 1);
        attendre("revenu");
    }

    @Test
    void unFichierQuiNEstPlusSuiviNeDitPlusRien() throws Exception {
        Path autre = Files.write(dossier.resolve("autre.ini"), "deux".getBytes());
        veille.suivre(autre.toString(), Surveillance.version(autre.toString()));
        ecrire("un", 2);
        Files.delete(fichier);
        assertNull(dits.poll(1200, TimeUnit.MILLISECONDS));
        Files.delete(autre);
        attendre("celui qui est suivi");
    }
}
