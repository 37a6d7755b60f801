package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import javax.swing.JFrame;
import javax.swing.JMenuBar;

/** Ce qui se voit, assemblé : les menus, l'image, la barre d'état. */
final class Cadre extends JFrame {

    private static final long serialVersionUID = 1;

    /** @param image taille demandée pour l'image, réduite s'il le faut pour que tout tienne à l'écran */
    Cadre(JMenuBar menus, PanneauImage panneau, BarreEtat barre, Dimension image) {
        setJMenuBar(menus);
        panneau.setPreferredSize(image);
        add(panneau, BorderLayout.CENTER);
        add(barre, BorderLayout.PAGE_END);
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        pack();
        Rectangle ecran = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setSize(Math.min(getWidth(), ecran.width), Math.min(getHeight(), ecran.height));
        setLocationRelativeTo(null);
        validate();
    }
}
