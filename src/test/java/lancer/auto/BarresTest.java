package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.IntStream;
import javax.swing.UIManager;
import lancer.fenetre.figures.GraphiqueVitesse;
import org.junit.jupiter.api.Test;

/** Ce que le graphique peint des bornes d'un candidat. */
class BarresTest {

    private static final int L = 560;
    private static final int H = 400;

    private static Candidat candidat(double carre, double variance, double prix) {
        return new Candidat(null, null, Limite.permises(5, 0.0)[0], new Estimation(carre, variance), prix, 100);
    }

    @Test
    void uneErreurQuiPeutEtreNulleSePeintAuPlusUnPlafondEtUneFlecheVersLeBas() {
        Candidat sur = candidat(4, 0.1, 2);
        Candidat auPlus = candidat(0.04, 0.09, 20);
        assertEquals(0, auPlus.auMoins);
        UIManager.put("Component.accentColor", new Color(0x1F5FA8));
        GraphiqueVitesse graphique = new GraphiqueVitesse(c -> { }, texte -> { }, c -> false);
        graphique.setSize(L, H);
        graphique.montrer(Arrays.asList(sur, auPlus), null, 1e6);
        BufferedImage peint = new BufferedImage(L, H, BufferedImage.TYPE_INT_RGB);
        graphique.paint(peint.createGraphics());
        // le trait du front va de l'un à l'autre : on regarde à gauche du moins cher, à droite du plus cher
        int[] colonnes = IntStream.range(0, L).filter(x -> marques(peint, x) > 0).toArray();
        assertEquals(1, marques(peint, colonnes[0] + 2), "un disque seul, à côté de sa barre");
        assertEquals(3, marques(peint, colonnes[colonnes.length - 1] - 2), "un plafond, un disque et une pointe");
    }

    @Test
    void unPointAtteintParUneFlecheDitSonTempsSonErreurEtCeQuOnYGagne() {
        Candidat vite = candidat(4, 0.1, 2);
        Candidat juste = candidat(1, 0.01, 20);
        String[] dit = {""};
        GraphiqueVitesse graphique = new GraphiqueVitesse(c -> { }, texte -> dit[0] = texte, c -> c == vite);
        graphique.setSize(L, H);
        // deux rayons de cent nanosecondes par pixel, un million de pixels : deux dixièmes de seconde
        graphique.montrer(Arrays.asList(vite, juste), null, 1e6);
        for (int k = 0; k < 2; k++) {
            graphique.getKeyListeners()[0].keyPressed(new KeyEvent(graphique, KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_RIGHT,
                    KeyEvent.CHAR_UNDEFINED));
            assertTrue(dit[0].contains(k == 0 ? " — 0,2 s, 2,0 rayons par pixel, erreur " : " — 2 s, 20,0 rayons par pixel, erreur "),
                    dit[0]);
        }
        assertTrue(dit[0].endsWith("au lieu du présent, 10,0 fois plus de temps et 2,0 fois moins d'erreur"), dit[0]);
    }

    /** Combien de morceaux de cette colonne sont du bleu du front. */
    private static int marques(BufferedImage peint, int x) {
        return (int) IntStream.range(1, H).filter(y -> estBleu(peint.getRGB(x, y)) && !estBleu(peint.getRGB(x, y - 1))).count();
    }

    private static boolean estBleu(int code) {
        return (code & 0xFF) - (code >> 16 & 0xFF) > 50;
    }
}
