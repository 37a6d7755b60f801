package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import lancer.Scene;
import lancer.mesures.FichierCsv;
import lancer.mesures.scenes.SceneAuHasard;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce qui juge {@code --auto}. */
class MesureAutoTest {

    @TempDir
    Path dossier;

    /** Plus d'erreur permise ne coûte jamais plus cher ; sur une scène simple, l'échelon choisi est presque le moins cher qui tient. */
    @Test
    void uneSceneSimpleEstTenuePresqueAuPrixDuMoinsCherDesEchelons() throws IOException {
        Scene scene = SceneAuHasard.de(3);
        List<String> lignes = new ArrayList<>(MesureAuto.lignes("sort-3", scene, new Taille(96, 72), 2, 4, 8));
        lignes.add(0, MesureAuto.COLONNES);
        List<Map<String, String>> lues = FichierCsv.lire(Files.write(dossier.resolve("auto.csv"), lignes, StandardCharsets.UTF_8));
        Map<String, String> bilan = MesureAuto.bilan(lues);
        assertEquals("3 fois sur 3", bilan.get("tenues"), "" + lues);
        assertEquals("3 fois sur 3", bilan.get("justes"), "" + lues);
        assertEquals("0 fois sur 3", bilan.get("a_tort"), "" + lues);
        double prix = Double.POSITIVE_INFINITY;
        for (Map<String, String> ligne : lues) {
            double moinsCher = Double.parseDouble(ligne.get("rayons_moins_cher"));
            assertTrue(moinsCher <= prix && Double.parseDouble(ligne.get("rayons")) <= 2 * moinsCher, "" + ligne);
            prix = moinsCher;
        }
    }

    @Test
    void ceQuiEstTenuEtSonPrixSontComptes() throws IOException {
        List<String> lignes = new ArrayList<>();
        lignes.add(MesureAuto.COLONNES);
        lignes.add("a,10x10,2,r,1,1.2,0.3,tenue,10,5,m,10,3,2,c,d");
        lignes.add("b,10x10,2,r,2.5,2,0.4,tenue,30,7000,m,20,3,1,c,d");
        lignes.add("c,10x10,2,r,4,5,1,dépassée,30,5,m,20,4,1,c,d");
        lignes.add("d,10x10,2,r,4,3,2,tenue,30,5,,,1,,c,d");
        Map<String, String> bilan = MesureAuto.bilan(FichierCsv.lire(Files.write(dossier.resolve("a.csv"), lignes,
                StandardCharsets.UTF_8)));
        assertEquals("{a_tort=2 fois sur 4, dites_depassees=1 fois sur 4, dites_incertaines=0 fois sur 4, dites_tenues=3 fois sur 4, "
                + "justes=3 fois sur 4, prix=1.750, secondes=2.500, tenues=1 fois sur 3}", bilan.toString());
    }
}
