package lancer.fenetre.figures;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;

class GraphiqueVitesseTest {

    private static BufferedImage peindre(List<GraphiqueVitesse.Reglage> points) {
        GraphiqueVitesse graphique = new GraphiqueVitesse(() -> { }, texte -> { });
        graphique.setSize(420, 400);
        graphique.montrer(points, null);
        BufferedImage vue = new BufferedImage(420, 400, BufferedImage.TYPE_INT_RGB);
        graphique.paint(vue.createGraphics());
        return vue;
    }

    @Test
    void aucunNomNEstEcritSurUnTraitNiSurUnPoint() {
        SplittableRandom hasard = new SplittableRandom(52);
        int fond = UIManager.getColor("Tree.background").getRGB();
        int trame = UIManager.getColor("Panel.background").getRGB();
        int ecrits = 0;
        for (int essai = 0; essai < 40; essai++) {
            List<GraphiqueVitesse.Reglage> nommes = new ArrayList<>();
            List<GraphiqueVitesse.Reglage> sansNom = new ArrayList<>();
            for (int k = 0; k < 9; k++) {
                double secondes = 0.1 * Math.exp(0.4 * k + hasard.nextDouble());
                double erreur = 20 * Math.exp(-0.5 * k - hasard.nextDouble());
                nommes.add(new GraphiqueVitesse.Reglage("partage n=" + k + " seuil=0.15", "", secondes, erreur, 0.2 * erreur));
                sansNom.add(new GraphiqueVitesse.Reglage("", "", secondes, erreur, 0.2 * erreur));
            }
            BufferedImage avec = peindre(nommes);
            BufferedImage sans = peindre(sansNom);
            for (int k = 0; k < 420 * 400; k++) {
                int dessous = sans.getRGB(k % 420, k / 420);
                if (avec.getRGB(k % 420, k / 420) != dessous) {
                    ecrits++;
                    assertTrue(dessous == fond || dessous == trame, "essai " + essai + ", en " + k % 420 + ", " + k / 420);
                }
            }
        }
        assertTrue(ecrits > 10_000, ecrits + " pixels de noms");
    }
}
