package lancer.systeme;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.io.IOError;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.AccessDeniedException;
import org.junit.jupiter.api.Test;

/** Ce qui dépend de la console et du système, essayé ici pour tous. */
class ConsoleTest {

    @Test
    void unSigneQueLaConsoleNAPasEstRemplaceParUnVoisin() {
        String terme = "Kd ⊗ K · (N·L) = 0.5 − 1, « reflété »";
        assertEquals(terme, Console.avecSignesVoisins(terme, Charset.forName("UTF-8")));
        for (String codage : new String[] {"IBM850", "windows-1252"}) {
            String dit = Console.avecSignesVoisins(terme, Charset.forName(codage));
            assertEquals("Kd × K · (N·L) = 0.5 - 1, « reflété »", dit);
            assertEquals(dit, new String(dit.getBytes(Charset.forName(codage)), Charset.forName(codage)), codage);
        }
    }

    @Test
    void unMotDUneCommandeEstAccepteParLInterpreteurDeSonSysteme() {
        assertEquals("target/lancer.jar", Console.motUnix("target/lancer.jar"));
        assertEquals("421,426", Console.motUnix("421,426"));
        assertEquals("'l'\\''été $x.ini'", Console.motUnix("l'été $x.ini"));
        assertEquals("target\\lancer.jar", Console.motWindows("target\\lancer.jar"));
        assertEquals("\"421,426\"", Console.motWindows("421,426"));
        assertEquals("\"a.jar;b.jar\"", Console.motWindows("a.jar;b.jar"));
        assertEquals("\"C:\\l'été\\ma scène.ini\"", Console.motWindows("C:\\l'été\\ma scène.ini"));
    }

    @Test
    void laReponseDuSystemeEstDiteAvecNosMots() {
        assertEquals("ce lecteur n'existe pas", ErreurSysteme.raison(new IOError(new IOException("drive 'Q'")), "Q:x.png"));
        assertEquals("c'est un dossier", ErreurSysteme.raison(new AccessDeniedException("d"), new File("").getAbsolutePath()));
        assertEquals("accès interdit", ErreurSysteme.raison(new AccessDeniedException("d"), "absent.png"));
    }
}
