package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;

/** Ce qui se voit, assemblé : les menus, l'image, la barre d'état ; et à quoi la fenêtre répond. */
final class Cadre extends JFrame {

    private static final long serialVersionUID = 1;

    /** @param image taille demandée pour l'image, réduite s'il le faut pour que tout tienne à l'écran */
    Cadre(Fenetre fenetre, PanneauImage panneau, BarreEtat barre, Dimension image) {
        setJMenuBar(new MenuFenetre(fenetre));
        panneau.setPreferredSize(image);
        add(panneau, BorderLayout.CENTER);
        add(barre, BorderLayout.PAGE_END);
        getRootPane().setTransferHandler(new DepotFichier(fenetre));
        getRootPane().registerKeyboardAction(e -> fenetre.arreter(), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
                JComponent.WHEN_IN_FOCUSED_WINDOW);
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                fenetre.fermer();
            }
        });
        panneau.suivreSouris(fenetre::montrerPixel);
        panneau.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                fenetre.suivreTaille();
            }
        });
        // un écran d'une autre densité : les mêmes points, plus ou moins de pixels
        panneau.addPropertyChangeListener("graphicsConfiguration", e -> fenetre.suivreTaille());
        pack();
        Rectangle ecran = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setSize(Math.min(getWidth(), ecran.width), Math.min(getHeight(), ecran.height));
        setLocationRelativeTo(null);
        validate();
    }
}
