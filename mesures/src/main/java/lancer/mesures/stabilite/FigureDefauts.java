package lancer.mesures.stabilite;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import lancer.antialias.Antialias;
import lancer.essai.Defauts;
import lancer.mesures.trace.Style;

/** Les défauts courants, comptés et montrés. */
final class FigureDefauts {

    /** La figure, dans le CSV : x = rang du défaut. */
    static final String FIGURE = "defauts";
    static final String PROGRAMME = "programme";

    /** Nombre de pixels faux au-dessous duquel chacun est grossi. */
    private static final int RARES = 10;

    private FigureDefauts() {
    }

    static List<Defauts.Defaut> tous() {
        return new Defauts(Antialias.coins(3, 0)).tous();
    }

    /** De chacun, les pixels faux, puis ceux du programme. */
    static List<Exactitude> compter() {
        List<Exactitude> exactitudes = new ArrayList<>();
        for (Defauts.Defaut d : tous()) {
            int rang = exactitudes.size() / 2;
            exactitudes.add(new Exactitude(FIGURE, d.cle, rang, 0, d.juges(), d.faux(d.naive), 0, 0));
            exactitudes.add(new Exactitude(FIGURE, PROGRAMME, rang, 0, d.juges(), d.faux(d.programme), 0, 0));
        }
        return exactitudes;
    }

    /** L'image juste, celle du défaut, et où celle-ci est fausse ; de rares pixels sont grossis. */
    static BufferedImage image(Defauts.Defaut d) {
        int cote = d.cote;
        BufferedImage image = new BufferedImage(3 * cote + 4, cote, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(Style.BANDE);
        g.fillRect(2 * cote + 4, 0, cote, cote);
        g.setColor(Style.VERMILLON);
        int bord = d.faux(d.naive) < RARES ? 2 : 0;
        for (int k = 0; k < cote * cote; k++) {
            image.setRGB(k % cote, k / cote, d.programme[k].getCode());
            image.setRGB(k % cote + cote + 2, k / cote, d.naive[k].getCode());
            if (d.estFaux(k, d.naive)) {
                g.fillRect(k % cote + 2 * cote + 4 - bord, k / cote - bord, 2 * bord + 1, 2 * bord + 1);
            }
        }
        return image;
    }
}
