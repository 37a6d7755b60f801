package lancer.fenetre.figures;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.stream.Collectors;
import javax.swing.JPanel;
import lancer.inspection.Echantillon;
import lancer.inspection.Inspection;

/** Les échantillons d'un pixel, chacun à sa place et de sa couleur ; cliquer sur l'un le choisit. */
public final class GrilleEchantillons extends JPanel {

    private static final long serialVersionUID = 1;

    private static final int COTE = 180;

    private transient List<Echantillon> echantillons = Collections.emptyList();
    private transient List<Rectangle> places = Collections.emptyList();
    private int choisi = -1;

    /** @param siChoisi reçoit le rang de l'échantillon */
    public GrilleEchantillons(IntConsumer siChoisi) {
        setName("echantillons");
        setPreferredSize(new Dimension(COTE, COTE));
        setOpaque(false);
        getAccessibleContext().setAccessibleName("échantillons du pixel");
        setToolTipText("échantillons du pixel ; cliquer pour en choisir un, ou Ctrl et page suivante, page précédente");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                for (int k = 0; k < places.size(); k++) {
                    if (places.get(k).contains(e.getPoint())) {
                        siChoisi.accept(k);
                    }
                }
            }
        });
    }

    public void montrer(Inspection pixel) {
        echantillons = pixel.getEchantillons();
        choisi = echantillons.indexOf(pixel.getChoisi());
        // l'écart de deux voisins : le premier est à un demi-pas du bord ; et la largeur de tout, en pixels de l'image
        double pas = echantillons.stream().mapToDouble(e -> 2 * Math.min(e.xe % 1, e.ye % 1)).min().orElse(1);
        double etendue = echantillons.stream()
                .mapToDouble(e -> Math.max(e.xe - pixel.x, e.ye - pixel.y) + pas / 2).max().orElse(1);
        double taille = COTE / etendue;
        places = echantillons.stream().map(e -> new Rectangle((int) ((e.xe - pixel.x - pas / 2) * taille),
                (int) ((e.ye - pixel.y - pas / 2) * taille), (int) (pas * taille), (int) (pas * taille)))
                .collect(Collectors.toList());
        setVisible(echantillons.size() > 1);
        repaint();
    }

    /** Le rang de l'échantillon d'avant ou d'après celui qui est choisi. */
    public int voisin(int sens) {
        return Math.max(0, Math.min(echantillons.size() - 1, choisi + sens));
    }

    @Override
    protected void paintComponent(Graphics g) {
        for (int k = 0; k < places.size(); k++) {
            Rectangle place = places.get(k);
            g.setColor(new Color(echantillons.get(k).couleur.getCode()));
            g.fillRect(place.x, place.y, place.width, place.height);
        }
        if (choisi >= 0) {
            Rectangle place = places.get(choisi);
            g.setColor(Color.WHITE);
            g.drawRect(place.x, place.y, place.width - 1, place.height - 1);
            g.setColor(Color.BLACK);
            g.drawRect(place.x + 1, place.y + 1, place.width - 3, place.height - 3);
        }
    }
}
