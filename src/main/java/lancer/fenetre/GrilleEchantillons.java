package lancer.fenetre;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.List;
import java.util.function.IntConsumer;
import javax.swing.JComponent;
import lancer.inspection.Echantillon;
import lancer.inspection.Inspection;

/** Les échantillons d'un pixel, chacun à sa place et de sa couleur ; cliquer sur l'un le choisit. */
final class GrilleEchantillons extends JComponent {

    private static final long serialVersionUID = 1;

    private static final int COTE = 180;

    private transient List<Echantillon> echantillons = Collections.emptyList();
    private int choisi = -1;
    private double x0;
    private double y0;
    /** L'écart entre deux échantillons voisins, et la largeur de ce qui est montré, en pixels de l'image. */
    private double pas;
    private double etendue;

    /** @param siChoisi reçoit le rang de l'échantillon */
    GrilleEchantillons(IntConsumer siChoisi) {
        setName("echantillons");
        setToolTipText("échantillons du pixel ; cliquer pour en choisir un, ou page suivante, page précédente");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                for (int k = 0; k < echantillons.size(); k++) {
                    if (place(k).contains(e.getPoint())) {
                        siChoisi.accept(k);
                    }
                }
            }
        });
    }

    void montrer(Inspection pixel) {
        echantillons = pixel.getEchantillons();
        choisi = echantillons.indexOf(pixel.getChoisi());
        x0 = pixel.x;
        y0 = pixel.y;
        pas = 1;
        etendue = 1;
        for (Echantillon e : echantillons) {
            // le premier sous-pixel est à un demi-pas du bord
            pas = Math.min(pas, 2 * Math.min(e.xe - Math.floor(e.xe), e.ye - Math.floor(e.ye)));
        }
        for (Echantillon e : echantillons) {
            etendue = Math.max(etendue, Math.max(e.xe - x0, e.ye - y0) + pas / 2);
        }
        setVisible(echantillons.size() > 1);
        setPreferredSize(new Dimension(COTE, COTE));
        revalidate();
        repaint();
    }

    /** Le rang de l'échantillon d'avant ou d'après celui qui est choisi. */
    int voisin(int sens) {
        return Math.max(0, Math.min(echantillons.size() - 1, choisi + sens));
    }

    private Rectangle place(int k) {
        Echantillon e = echantillons.get(k);
        double taille = COTE / etendue;
        int gauche = (int) ((e.xe - x0 - pas / 2) * taille);
        int haut = (int) ((e.ye - y0 - pas / 2) * taille);
        return new Rectangle(gauche, haut, (int) ((e.xe - x0 + pas / 2) * taille) - gauche,
                (int) ((e.ye - y0 + pas / 2) * taille) - haut);
    }

    @Override
    protected void paintComponent(Graphics g) {
        for (int k = 0; k < echantillons.size(); k++) {
            Rectangle place = place(k);
            g.setColor(new Color(echantillons.get(k).couleur.getCode()));
            g.fillRect(place.x, place.y, place.width - 1, place.height - 1);
        }
        g.setColor(Color.GRAY);
        g.drawRect(0, 0, (int) (COTE / etendue) - 1, (int) (COTE / etendue) - 1);
        if (choisi >= 0) {
            Rectangle place = place(choisi);
            g.setColor(Color.WHITE);
            g.drawRect(place.x, place.y, place.width - 2, place.height - 2);
            g.setColor(Color.BLACK);
            g.drawRect(place.x + 1, place.y + 1, place.width - 4, place.height - 4);
        }
    }
}
