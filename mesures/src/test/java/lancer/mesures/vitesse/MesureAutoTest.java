package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import lancer.Scene;
import lancer.mesures.scenes.Scenes;
import lancer.scene.LecteurScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce qui juge {@code --auto}. */
class MesureAutoTest {

    private static String bilan(List<String> lignes) {
        return MesureAuto.tableau(lignes.stream().map(l -> l.split(",", -1)).collect(Collectors.toList())).trim().split("\n")[2];
    }

    /** Plus d'erreur permise ne coûte jamais plus cher ; sur une scène simple, aucune erreur n'est dite tenue à tort. */
    @Test
    void uneSceneSimpleEstTenue() {
        Scene diffus = Scenes.lire(LecteurScene.trouver("scenes/diffus.ini"));
        List<MesureAuto.Reponse> reponses = MesureAuto.repondre("diffus", diffus, new Taille(96, 72), 2, 4, 8);
        double prix = Double.POSITIVE_INFINITY;
        for (MesureAuto.Reponse r : reponses) {
            assertTrue(!r.verdict.equals("tenue") || r.nombre("vraie") <= r.nombre("voulue"), r.ligne);
            assertTrue(r.nombre("moins_cher") <= prix && r.nombre("rayons") > 0 && r.nombre("essais") > 0, r.ligne);
            prix = r.nombre("moins_cher");
        }
        String bilan = bilan(reponses.stream().map(r -> r.ligne).collect(Collectors.toList()));
        assertTrue(bilan.startsWith("| scènes communes | 3 fois sur 3 | "), bilan);
    }

    /** Une étoile dans le noir : ni son erreur ni une autre ne sont annoncées de ce qui n'a pas été vu. */
    @Test
    void deCeQuiNEstPasVuRienNEstAnnonce(@TempDir Path dossier) throws IOException {
        for (MesureAuto.Reponse r : MesureAuto.repondre("etoile", Scenes.lire(Scenes.fichier("etoile", dossier)), new Taille(96, 72), 1)) {
            assertTrue(r.verdict.equals("rien vu") == Double.isNaN(r.nombre("incertitude")), r.ligne);
            assertTrue(!r.verdict.equals("tenue") || r.nombre("vraie") <= r.nombre("voulue"), r.ligne);
        }
    }

    @Test
    void ceQuiEstTenuEtSonPrixSontComptes() {
        assertEquals("| scènes communes | 2 fois sur 3 | 2 fois sur 4 | 1 fois sur 2 | 1 fois sur 4 | 1 fois sur 4 | 3 fois sur 3 | "
                + "× 1,5 | × 1,5 |",
                bilan(List.of("a,10x10,2,r,1,1.2,0.3,tenue,10,5,10,c,d", "b,10x10,2,r,2.5,2,0.4,tenue,10,10,,c,d",
                        "c,10x10,2,r,4,5,1,dépassée,10,5,10,c,d", "d,10x10,2,r,4,0,,rien vu,10,5,10,c,d")));
    }
}
