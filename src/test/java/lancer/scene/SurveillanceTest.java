package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** L'observation du fichier d'une scène : sa version, dès que deux observations de suite l'ont trouvée. */
@Timeout(60)
class SurveillanceTest {

    @TempDir
    Path dossier;
    private final LinkedBlockingQueue<String> dites = new LinkedBlockingQueue<>();
    private final Surveillance veille = new Surveillance((nom, version) -> dites.add(nom + " " + version));
    private Path fichier;

    @BeforeEach
    void suivreUnFichier() throws IOException {
        fichier = dossier.resolve("s.ini");
        ecrire("un", 1);
        veille.suivre(fichier.toString());
    }

    @AfterEach
    void terminer() {
        veille.terminer();
    }

    private void ecrire(String texte, int date) throws IOException {
        // d'un coup : de deux versions, deux seraient annoncées
        Path neuf = Files.writeString(dossier.resolve("neuf"), texte);
        Files.setLastModifiedTime(neuf, FileTime.from(date, TimeUnit.HOURS));
        Files.move(neuf, fichier, StandardCopyOption.ATOMIC_MOVE);
    }

    /** Attend que la version annoncée soit celle d'à présent de ce fichier ; ce qui a été observé avant peut la précéder. */
    private String attendre(Path celui) throws InterruptedException {
        String voulue = celui + " " + Surveillance.version(celui.toString());
        String dite = dites.take();
        while (!dite.equals(voulue)) {
            dite = dites.take();
        }
        return dite;
    }

    @Test
    void uneAutreDateNEstPasUneAutreVersionEtDAutresOctetsEnSontUne() throws Exception {
        Set<String> versions = new HashSet<>();
        assertTrue(versions.add(attendre(fichier)));
        ecrire("un", 2);
        assertFalse(versions.add(attendre(fichier)), "une autre date, et les mêmes octets");
        ecrire("trois", 2);
        assertTrue(versions.add(attendre(fichier)), "une autre taille");
    }

    @Test
    void unFichierEffaceSeDitPuisSonRetourALaMemeVersion() throws Exception {
        String avant = attendre(fichier);
        Files.delete(fichier);
        assertNotEquals(avant, attendre(fichier));
        ecrire("un", 1);
        assertEquals(avant, attendre(fichier), "revenu tel qu'il était");
    }

    @Test
    void unFichierQuiNEstPlusSuiviNeDitPlusRien() throws Exception {
        Path autre = Files.writeString(dossier.resolve("autre.ini"), "deux");
        veille.suivre(autre.toString());
        attendre(autre);
        ecrire("un", 2);
        Files.delete(fichier);
        for (int observations = 0; observations < 3; observations++) {
            veille.run();
        }
        assertTrue(dites.stream().allMatch(dite -> dite.startsWith(autre + " ")), dites.toString());
        Files.delete(autre);
        attendre(autre);
    }
}
