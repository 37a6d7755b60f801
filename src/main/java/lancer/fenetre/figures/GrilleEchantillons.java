package lancer.fenetre.figures;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.List;
import java.util.function.IntConsumer;
import javax.swing.JPanel;
import lancer.inspection.Echantillon;
import lancer.inspection.Inspection;

/** Les échantillons d'un pixel, chacun à sa place et de sa couleur ; cliquer sur l'un le choisit. */
@SuppressWarnings("serial")
public final class GrilleEchantillons extends JPanel {

    private List<Echantillon> echantillons = Collections.emptyList();
    private Inspection pixel;
    /** L'écart de deux voisins, et la largeur de tout, en pixels de l'image. */
    private double pas;
    private double etendue;
    private int choisi = -1;

    /** @param siChoisi reçoit le rang de l'échantillon */
    public GrilleEchantillons(IntConsumer siChoisi) {
        setName("echantillons");
        setOpaque(false);
        getAccessibleContext().setAccessibleName("échantillons du pixel");
        setToolTipText("échantillons du pixel ; cliquer pour en choisir un, ou Ctrl et page suivante, page précédente");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                echantillons.stream().filter(echantillon -> place(echantillon).contains(e.getPoint())).findFirst()
                        .ifPresent(echantillon -> siChoisi.accept(echantillons.indexOf(echantillon)));
            }
        });
    }

    public void montrer(Inspection nouvelle) {
        pixel = nouvelle;
        echantillons = pixel.getEchantillons();
        choisi = echantillons.indexOf(pixel.getChoisi());
        // le premier est à un demi-pas du bord
        pas = echantillons.stream().mapToDouble(e -> 2 * Math.min(e.xe % 1, e.ye % 1)).min().orElse(1);
        etendue = echantillons.stream()
                .mapToDouble(e -> Math.max(e.xe - pixel.x, e.ye - pixel.y) + pas / 2).max().orElse(1);
        setVisible(echantillons.size() > 1);
        repaint();
    }

    private Rectangle place(Echantillon e) {
        double taille = Math.min(getWidth(), getHeight()) / etendue;
        return new Rectangle((int) ((e.xe - pixel.x - pas / 2) * taille),
                (int) ((e.ye - pixel.y - pas / 2) * taille), (int) (pas * taille), (int) (pas * taille));
    }

    /** Le rang de l'échantillon d'avant ou d'après celui qui est choisi. */
    public int voisin(int sens) {
        return Math.max(0, Math.min(echantillons.size() - 1, choisi + sens));
    }

    @Override
    protected void paintComponent(Graphics g) {
        for (Echantillon echantillon : echantillons) {
            Rectangle place = place(echantillon);
            g.setColor(new Color(echantillon.couleur.getCode()));
            g.fillRect(place.x, place.y, place.width, place.height);
        }
        if (choisi >= 0) {
            Rectangle place = place(echantillons.get(choisi));
            g.setColor(Color.WHITE);
            g.drawRect(place.x, place.y, place.width - 1, place.height - 1);
            g.setColor(Color.BLACK);
            g.drawRect(place.x + 1, place.y + 1, place.width - 3, place.height - 3);
        }
    }
}
