package lancer.correction.note;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SortiesTest {

    @TempDir
    Path dossier;

    /** Linux refuse d'écrire dans un programme qui s'exécute, comme Windows dans un tableau qu'un tableur tient ouvert. */
    @Test
    void unTableauTenuParUnAutreProgrammeEstEcritACote() throws Exception {
        Path classe = dossier.resolve("classe.csv");
        Path programme = Path.of("/bin/sleep");
        assumeTrue(Files.isExecutable(programme), "il faut un programme à exécuter");
        Files.copy(programme, classe, StandardCopyOption.COPY_ATTRIBUTES);
        Files.write(dossier.resolve("classe-2.csv"), new byte[] {7});
        Process tient = new ProcessBuilder(classe.toString(), "60").start();
        try {
            assumeTrue(estTenu(classe), "ce noyau laisse écrire dans un programme qui s'exécute");
            Sorties sorties = new Sorties();
            sorties.ecrire(classe, new byte[] {1, 2});
            assertArrayEquals(new byte[] {1, 2}, Files.readAllBytes(dossier.resolve("classe-3.csv")));
            assertEquals(List.of("classe.csv est tenu par un autre programme : ce qu'il faut y lire est dans classe-3.csv"),
                    sorties.aCote());
        } finally {
            tient.destroy();
            tient.waitFor();
        }
    }

    private static boolean estTenu(Path fichier) {
        try {
            Files.write(fichier, Files.readAllBytes(fichier));
            return false;
        } catch (IOException e) {
            return true;
        }
    }

    @Test
    void laReponseDuSystemeNeNommePasUneClasseDeJava() {
        assertEquals("a.csv : accès interdit, ou ouvert ailleurs", Sorties.raison(new AccessDeniedException("a.csv")));
        assertEquals("a.csv : disque plein", Sorties.raison(new FileSystemException("a.csv", null, "disque plein")));
    }
}
