package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Le menu Scènes : celles du dossier, d'une touche à l'autre. */
class FenetreScenesTest extends EssaiFenetre {

    private Path suivante;

    @BeforeEach
    void ecrireLesAutres() throws Exception {
        suivante = dossier.resolve("chat.ini");
        Files.write(suivante, BLEUE.getBytes(StandardCharsets.UTF_8));
        Files.write(dossier.resolve("abîmée.ini"), new byte[] {(byte) 0xFF, 0, 10});
        Files.createDirectory(dossier.resolve("dossier.ini"));
        Files.write(dossier.resolve("lisez-moi.txt"), new byte[0]);
    }

    private List<String> articles() {
        JMenu scenes = banc.cadre.getJMenuBar().getMenu(3);
        List<String> noms = new ArrayList<>();
        for (int k = 0; k < scenes.getItemCount(); k++) {
            JMenuItem article = scenes.getItem(k);
            noms.add(article == null ? "" : (article.isSelected() ? "* " : "") + article.getText());
        }
        return noms;
    }

    @Test
    void lesScenesDuDossierEtUneToucheMeneDeLUneALAutre() throws Exception {
        ouvrir();
        attendre("la liste est là", () -> articles().contains("* boule.ini"));
        assertEquals(Arrays.asList("Scène suivante", "Scène précédente", "", "abîmée.ini", "* boule.ini", "chat.ini"), articles());
        int[] rouge = attendue(L, H);
        banc.frapper(KeyEvent.VK_PAGE_DOWN);
        attendre("le titre est celui de la suivante", () -> banc.cadre.getTitle().equals("lancer — chat.ini"));
        scene = suivante;
        banc.attendreImage("elle est montrée", attendue(L, H));
        attendre("le menu le dit", () -> articles().contains("* chat.ini"));
        banc.frapper(KeyEvent.VK_PAGE_UP);
        banc.attendreImage("et la précédente", rouge);
        attendre("le menu la coche", () -> articles().contains("* boule.ini"));
        banc.frapper(KeyEvent.VK_PAGE_UP);
        banc.attendreMessage(dossier.resolve("abîmée.ini") + ", ligne 1 : ");
        assertArrayEquals(rouge, banc.imageAchevee().codes, "une scène qui ne se lit pas laisse l'image");
    }
}
