package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
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
import lancer.mesures.Gabarit;
import lancer.mesures.Intervalle;
import lancer.mesures.scenes.SceneAuHasard;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce qui juge {@code --auto}. */
class MesureAutoTest {

    @TempDir
    Path dossier;

    @Test
    void uneSceneSimpleEstTenuePresqueAuPrixDeLOracle() throws IOException {
        Scene scene = SceneAuHasard.de(3);
        List<String> lignes = new ArrayList<>(MesureAuto.lignes("sort-3", scene, new Taille(56, 42), 4, 8));
        lignes.add(0, MesureAuto.COLONNES);
        List<Map<String, String>> lues = FichierCsv.lire(Files.write(dossier.resolve("auto.csv"), lignes, StandardCharsets.UTF_8));
        assertEquals(2, lues.size());
        Map<String, String> bilan = MesureAuto.bilan(lues);
        assertEquals("2 fois sur 2", bilan.get("tenues"), "" + lues);
        assertEquals("0 fois sur 2", bilan.get("a_tort"), "" + lues);
        assertEquals("2 fois sur 2", bilan.get("essais"), "" + lues);
        assertTrue(Double.parseDouble(lues.get(0).get("rayons")) < 2 * Double.parseDouble(lues.get(0).get("rayons_oracle")), "" + lues);
    }

    @Test
    void ceQuiEstTenuEtSonPrixSontComptes() throws IOException {
        List<String> lignes = new ArrayList<>();
        lignes.add(MesureAuto.COLONNES);
        lignes.add("a,10x10,2,r,1,tenue,10,o,10,5,3,2");
        lignes.add("b,10x10,2,r,2.5,tenue,30,o,20,7000,3,1");
        lignes.add("c,10x10,2,r,4,dépassée,30,o,20,5,4,1");
        lignes.add("d,10x10,2,r,4,tenue,30,,,5,1,");
        Map<String, String> bilan = MesureAuto.bilan(FichierCsv.lire(Files.write(dossier.resolve("a.csv"), lignes,
                StandardCharsets.UTF_8)));
        assertEquals("{a_tort=2 fois sur 4, dites_depassees=1 fois sur 4, dites_incertaines=0 fois sur 4, "
                + "dites_tenues=3 fois sur 4, essais=3 fois sur 4, secondes=2.500, tenues=1 fois sur 3, "
                + "total=1.750, total90=351.500}", bilan.toString());
    }

    /** Plus d'erreur permise ne coûte jamais plus cher, et rien n'est jamais plus cher que le premier qui tient. */
    @Test
    void lOracleTrouveMoinsCherPourPlusDErreur() {
        Scene scene = SceneAuHasard.de(3);
        Taille taille = new Taille(56, 42);
        Gabarit gabarit = new Gabarit(scene, taille.largeur, taille.hauteur, 1);
        Oracle oracle = new Oracle(scene, taille, 1, image -> Intervalle.deLaRacine(gabarit.carres(image)).valeur);
        double prix = Double.POSITIVE_INFINITY;
        for (double voulue : new double[] {1, 2, 4, 100}) {
            Oracle.Essai mieux = oracle.leMoinsCher(voulue);
            assertTrue(mieux.erreur <= voulue && mieux.prix <= prix, mieux + " pour " + voulue);
            prix = mieux.prix;
        }
        assertNull(oracle.leMoinsCher(0));
    }
}
