package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import lancer.mesures.FichierCsv;
import lancer.mesures.scenes.SceneAuHasard;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce qui juge {@code --auto}. */
class MesureAutoTest {

    @TempDir
    Path dossier;

    private List<Map<String, String>> relire(String... lignes) throws IOException {
        List<String> toutes = new ArrayList<>(Arrays.asList(lignes));
        toutes.add(0, MesureAuto.COLONNES);
        return FichierCsv.lire(Files.write(dossier.resolve("auto.csv"), toutes, StandardCharsets.UTF_8));
    }

    /** Plus d'erreur permise ne coûte jamais plus cher ; sur une scène simple, l'échelon choisi est presque le moins cher qui tient. */
    @Test
    void uneSceneSimpleEstTenuePresqueAuPrixDuMoinsCherDesEchelons() throws IOException {
        List<Map<String, String>> lues = relire(MesureAuto.lignes("sort-3", SceneAuHasard.de(3), new Taille(96, 72), 2, 4, 8)
                .toArray(new String[0]));
        String tableau = MesureAuto.tableau(lues);
        assertTrue(tableau.contains("| 96 × 72 | 3 fois sur 3 | 3 fois sur 3 | "), tableau + lues);
        assertTrue(tableau.contains(" | 0 fois sur 3 | "), "dites tenues à tort : " + tableau);
        double prix = Double.POSITIVE_INFINITY;
        for (Map<String, String> ligne : lues) {
            double moinsCher = Double.parseDouble(ligne.get("rayons_moins_cher"));
            assertTrue(moinsCher <= prix && Double.parseDouble(ligne.get("rayons")) <= 2 * moinsCher, "" + ligne);
            prix = moinsCher;
        }
    }

    @Test
    void ceQuiEstTenuEtSonPrixSontComptes() throws IOException {
        String tableau = MesureAuto.tableau(relire("a,10x10,2,r,1,1.2,0.3,tenue,10,5,m,10,3,2,c,d",
                "b,10x10,2,r,2.5,2,0.4,tenue,30,7000,m,20,3,1,c,d", "c,10x10,2,r,4,5,1,dépassée,30,5,m,20,4,1,c,d",
                "d,10x10,2,r,4,3,2,tenue,30,5,,,1,,c,d"));
        assertEquals("| 10 × 10 | 3 fois sur 4 | 1 fois sur 3 | 3 fois sur 4 | 2 fois sur 4 | 1 fois sur 4 | 0 fois sur 4 | 1,75 | 2,5 |",
                tableau.trim().split("\n")[2]);
    }
}
