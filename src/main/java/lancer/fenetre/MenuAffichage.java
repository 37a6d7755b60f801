package lancer.fenetre;

import java.awt.Dimension;
import java.awt.GraphicsDevice;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;

/** Le menu de la taille : celle où l'image se dessine, celle où elle se montre, et le plein écran. */
final class MenuAffichage {

    final JMenu menu = Menus.menu("Affichage");
    private final JFrame cadre;
    private final PanneauImage panneau;
    private final JComponent barre;
    private final Dimension demandee;
    private final Runnable siChange;
    private final JMenuItem demander;
    private final JMenuItem remplir;
    private final JCheckBoxMenuItem plein;
    /** Celle du cadre avant le plein écran. */
    private Rectangle place;

    /**
     * @param barre ce que le plein écran cache, avec les menus
     * @param demandee la taille de l'image que dit la ligne de commande
     * @param siChange appelé quand {@link #getTaille} a peut-être changé
     */
    MenuAffichage(JFrame cadre, PanneauImage panneau, JComponent barre, Dimension demandee, Runnable siChange) {
        this.cadre = cadre;
        this.panneau = panneau;
        this.barre = barre;
        this.demandee = demandee;
        this.siChange = siChange;
        ButtonGroup tailles = new ButtonGroup();
        demander = Menus.choix(menu, tailles, "Taille demandée, " + demandee.width + " × " + demandee.height,
                Menus.ctrl(KeyEvent.VK_1), siChange);
        demander.setSelected(true);
        remplir = Menus.choix(menu, tailles, "Remplir la fenêtre", Menus.ctrl(KeyEvent.VK_0), siChange);
        plein = Menus.coche(menu, "Plein écran", Menus.touche(KeyEvent.VK_F11), this::basculer);
        menu.addSeparator();
        Menus.article(menu, "Loupe : plus près", Menus.ctrl(KeyEvent.VK_UP), () -> panneau.approcher(true));
        Menus.article(menu, "Loupe : plus loin", Menus.ctrl(KeyEvent.VK_DOWN), () -> panneau.approcher(false));
        // Ctrl+1 et Ctrl+0 sur un clavier français, où les chiffres demandent Maj, et au pavé numérique
        Menus.lier(cadre, Menus.ctrl(KeyEvent.VK_AMPERSAND), demander::doClick);
        Menus.lier(cadre, Menus.ctrl(KeyEvent.VK_NUMPAD1), demander::doClick);
        Menus.lier(cadre, Menus.ctrl(KeyEvent.getExtendedKeyCodeForChar('à')), remplir::doClick);
        Menus.lier(cadre, Menus.ctrl(KeyEvent.VK_NUMPAD0), remplir::doClick);
    }

    /** La taille où dessiner l'image, en pixels. */
    Dimension getTaille() {
        return remplir.isSelected() || plein.isSelected() ? panneau.getTailleMax(demandee) : demandee;
    }

    boolean estPlein() {
        return plein.isSelected();
    }

    void quitterLePleinEcran() {
        if (plein.isSelected()) {
            plein.doClick();
        }
    }

    private void basculer() {
        boolean entre = plein.isSelected();
        GraphicsDevice ecran = cadre.getGraphicsConfiguration().getDevice();
        List<Window> ouvertes = Arrays.stream(cadre.getOwnedWindows()).filter(Window::isVisible)
                .collect(Collectors.toList());
        place = entre ? cadre.getBounds() : place;
        // un cadre garde sa barre de titre, même en plein écran, et n'en change que fermé
        cadre.dispose();
        cadre.setUndecorated(entre);
        // cachés, des menus ne répondraient plus à leurs touches
        cadre.getJMenuBar().setPreferredSize(entre ? new Dimension() : null);
        barre.setVisible(!entre);
        panneau.bandeau.fautesSeules(entre);
        ecran.setFullScreenWindow(entre ? cadre : null);
        cadre.setBounds(entre ? cadre.getBounds() : place);
        cadre.setVisible(true);
        cadre.requestFocus();
        ouvertes.forEach(fenetre -> fenetre.setVisible(true));
        siChange.run();
    }
}
