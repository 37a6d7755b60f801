package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.event.KeyEvent;
import java.util.stream.IntStream;
import javax.swing.JTabbedPane;
import javax.swing.JTree;
import org.junit.jupiter.api.Test;

/** Le panneau s'ouvre à la largeur que demande sa plus longue ligne, dans les limites de l'écran. */
class FenetrePanneauTest extends EssaiFenetre {

    private static int coupees(JTree recit) {
        return (int) IntStream.range(0, recit.getRowCount())
                .filter(k -> recit.getRowBounds(k).x + recit.getRowBounds(k).width > recit.getVisibleRect().width).count();
    }

    @Test
    void aucuneLigneDuRecitNEstCoupeeSiDeuxCinquiemesDeLEcranSuffisent() throws Exception {
        ouvrir();
        cliquer(160, 120);
        EssaiInspecteur.attendreTitre(160, 120);
        JTree recit = composant("recit", JTree.class);
        JTabbedPane panneau = composant("panneau", JTabbedPane.class);
        int voulue = surFilEvenements(() -> recit.getPreferredSize().width);
        if (voulue + 40 < Onglets.getLargeurMax()) {
            attendre("tout se lit", () -> coupees(recit) == 0);
        } else {
            attendre("la plus grande largeur", () -> panneau.getWidth() == Onglets.getLargeurMax());
        }
        int image = surFilEvenements(banc.panneau::getWidth);
        int cadre = surFilEvenements(banc.cadre::getWidth);
        assertEquals(cadre, image + surFilEvenements(panneau::getWidth), 8, "le cadre les contient");
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("il se referme, et l'image garde sa place", () -> Math.abs(banc.cadre.getWidth() - image) <= 4);
    }
}
