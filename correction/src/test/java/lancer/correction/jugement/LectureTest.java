package lancer.correction.jugement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.correction.depot.Rendu;
import lancer.correction.isolement.Confinement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/** Les rendus d'une classe se lisent dans une machine confinée, et chacun ne coûte que sa ligne. */
@EnabledForJreRange(min = JRE.JAVA_17)
class LectureTest extends JuryEssai {

    @TempDir
    Path dossier;

    private Map<String, Rendu> lire(Path rendus, Confinement confinement) {
        return jury(confinement, PATIENTES).lire(rendus, false).stream().collect(Collectors.toMap(r -> r.nom, r -> r));
    }

    @Test
    void confineeOuNonLaMachineLitLesMemesRendus() throws IOException {
        Path rendus = Files.createDirectories(dossier.resolve("TP été"));
        ecrireCorrige(rendus.resolve("Zoé"));
        Files.writeString(rendus.resolve("Zoé/note.md"), "x");
        ecrireCorrige(dossier.resolve("王"));
        archiver(dossier.resolve("王"), rendus.resolve("王.zip"), "проект/");
        Path classe = dossier.resolve("classe.zip");
        archiver(rendus, classe, "");
        Files.createSymbolicLink(rendus.resolve("lien.zip"), classe);
        Confinement confinement = Confinement.essayer();
        for (Path lieu : List.of(rendus, classe)) {
            for (Confinement un : List.of(confinement, new Confinement(false, ""))) {
                Map<String, Rendu> lus = lire(lieu, un);
                assertEquals(8, lus.get("Zoé").sources.size());
                assertEquals(8, lus.get("王").sources.size());
                assertTrue(lus.get("王").sources.keySet().iterator().next().startsWith("王/проект/lancer-base/"));
                assertEquals(lieu == rendus ? List.of("lien refusé : lien.zip") : List.of(), lus.values().stream()
                        .flatMap(r -> r.refus.stream()).collect(Collectors.toList()));
            }
        }
    }

    /** Plus d'entrées que la mémoire de la machine n'en retient ; dans l'archive même, rien ne les compte avant. */
    @Test
    void uneArchiveQuiEpuiseLaMachineEstUneLigneEtLaMachineRepart() throws IOException {
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        Path classe = dossier.resolve("énorme.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(classe))) {
            for (int k = 0; k < 12_000; k++) {
                zip.putNextEntry(new ZipEntry("é".repeat(32_000) + k));
            }
        }
        Map<String, Rendu> lus = lire(classe, confinement);
        assertEquals(1, lus.size());
        assertTrue(lus.get("énorme").refus.get(0).matches("arrêté : .* \\(en lisant ses fichiers\\)"), lus.get("énorme").refus.toString());
        Path rendus = Files.createDirectories(dossier.resolve("rendus"));
        ecrireCorrige(rendus.resolve("un"));
        assertFalse(lire(rendus, confinement).get("un").sources.isEmpty());
    }
}
