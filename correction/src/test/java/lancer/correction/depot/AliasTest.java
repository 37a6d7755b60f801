package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce que l'enseignant déclare des noms que des étudiants ont changés. */
class AliasTest {

    @TempDir
    Path dossier;

    @Test
    void uneLigneFausseNeCouteQuElleEtLeFichierNEstJamaisEcrit() throws IOException {
        Path fichier = dossier.resolve("alias.csv");
        List<String> ids = List.of("101", "102", "Dupont, Jean");
        assertEquals(Map.of(), new Alias(dossier, ids).de("101"));
        assertFalse(Files.exists(fichier));
        for (String separateur : List.of(",", ";")) {
            Files.writeString(fichier, String.join("\n", "id,nom écrit,nom du cours", "101,Monde,Scene", "101,normale,getNormale",
                    "999,A,Scene", "102,Monde,Univers", "102,Point,Scene", "102,a.b,Scene", "102,Monde", "101,Univers,Scene",
                    "Participant102,Monde,Scene").replace(",", separateur) + "\n");
            Alias alias = new Alias(dossier, ids);
            assertEquals(Map.of("Scene", "Monde", "getNormale", "normale"), alias.de("101"));
            assertEquals(Map.of("Scene", "Monde"), alias.de("102"));
            assertEquals(6, alias.fautes.size(), alias.fautes.toString());
            assertEquals("alias.csv, ligne 4 : l'étudiant « 999 » n'existe pas", alias.fautes.get(0));
        }
        Files.writeString(fichier, Alias.ligne("Dupont, Jean", "Monde", "Scene"));
        assertEquals(Map.of("Scene", "Monde"), new Alias(dossier, ids).de("Dupont, Jean"), "la ligne que la page propose");
    }
}
