package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.IntStream;
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
        GraphiqueVitesse graphique = new GraphiqueVitesse(c -> { }, texte -> { }, c -> false);
        graphique.setSize(L, H);
        graphique.montrer(Arrays.asList(sur, auPlus), null);
        BufferedImage peint = new BufferedImage(L, H, BufferedImage.TYPE_INT_RGB);
        graphique.paint(peint.createGraphics());
        // le trait du front va de l'un à l'autre : on regarde à gauche du moins cher, à droite du plus cher
        int[] colonnes = IntStream.range(0, L).filter(x -> marques(peint, x) > 0).toArray();
        assertEquals(1, marques(peint, colonnes[0] + 2), "un disque seul, à côté de sa barre");
        assertEquals(3, marques(peint, colonnes[colonnes.length - 1] - 2), "un plafond, un disque et une pointe");
    }

    /** Combien de morceaux de cette colonne sont du bleu du front. */
    private static int marques(BufferedImage peint, int x) {
        return (int) IntStream.range(1, H).filter(y -> estBleu(peint.getRGB(x, y)) && !estBleu(peint.getRGB(x, y - 1))).count();
    }

    private static boolean estBleu(int code) {
        return (code & 0xFF) - (code >> 16 & 0xFF) > 50;
    }
}
