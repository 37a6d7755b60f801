package lancer.fenetre;

import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;

/** De quoi faire des menus, où chaque article se choisit aussi par une lettre que ses voisins n'ont pas. */
final class Menus {

    private Menus() {
    }

    static JMenu menu(String nom) {
        JMenu menu = new JMenu(nom);
        menu.setMnemonic(nom.charAt(0));
        return menu;
    }

    /** La touche Ctrl, ou Commande sur un Mac, et une autre. */
    static KeyStroke ctrl(int touche) {
        // la forme en Ex est de Java 10
        return KeyStroke.getKeyStroke(touche, Toolkit.getDefaultToolkit().getMenuShortcutKeyMask());
    }

    static KeyStroke touche(int touche) {
        return KeyStroke.getKeyStroke(touche, 0);
    }

    /** @param touche celle qui le choisit sans le menu, ou {@code null} */
    static JMenuItem article(JMenu menu, String nom, KeyStroke touche, Runnable action) {
        return article(menu, new JMenuItem(nom), touche, action);
    }

    static JCheckBoxMenuItem coche(JMenu menu, String nom, KeyStroke touche, Runnable action) {
        return article(menu, new JCheckBoxMenuItem(nom), touche, action);
    }

    static JRadioButtonMenuItem choix(JMenu menu, ButtonGroup groupe, String nom, KeyStroke touche, Runnable action) {
        JRadioButtonMenuItem choix = article(menu, new JRadioButtonMenuItem(nom), touche, action);
        groupe.add(choix);
        return choix;
    }

    /** Lie une touche à ce qui n'a pas d'article ; à la racine du cadre, elle manquerait à un menu ouvert. */
    static void lier(JFrame cadre, KeyStroke touche, Runnable action) {
        JComponent contenu = (JComponent) cadre.getContentPane();
        contenu.registerKeyboardAction(e -> action.run(), touche, JComponent.WHEN_IN_FOCUSED_WINDOW);
    }

    /** Grise cet article tant qu'aucune scène n'est montrée. */
    static void siScene(Atelier atelier, JMenuItem article) {
        article.setEnabled(false);
        atelier.prevenir(() -> article.setEnabled(atelier.getReglages() != null));
    }

    private static <T extends JMenuItem> T article(JMenu menu, T article, KeyStroke touche, Runnable action) {
        article.setMnemonic(lettreLibre(menu, article.getText()));
        article.setAccelerator(touche);
        article.addActionListener(e -> action.run());
        menu.add(article);
        return article;
    }

    /** Montre cette fenêtre à côté de celle dont elle dépend, qui laisse la place qu'elle peut, et des autres. */
    static void aCote(Window fenetre) {
        if (!fenetre.isVisible()) {
            Window cadre = fenetre.getOwner();
            Rectangle ecran = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
            fenetre.setSize(Math.min(fenetre.getWidth(), ecran.width), Math.min(fenetre.getHeight(), ecran.height));
            int depasse = cadre.getX() + cadre.getWidth() + fenetre.getWidth() - ecran.x - ecran.width;
            if (depasse > 0 && cadre.getX() > ecran.x) {
                cadre.setLocation(Math.max(ecran.x, cadre.getX() - depasse), cadre.getY());
            }
            List<Rectangle> prises = Arrays.stream(cadre.getOwnedWindows()).filter(Window::isVisible)
                    .map(Window::getBounds).collect(Collectors.toList());
            fenetre.setLocation(place(fenetre.getSize(), ecran, cadre.getBounds(), prises));
        }
        fenetre.setVisible(true);
    }

    /**
     * La place d'une fenêtre dans l'écran : là où elle cache le moins des autres, puis du cadre ; plutôt à droite.
     *
     * @param prises la place des autres
     */
    static Point place(Dimension taille, Rectangle ecran, Rectangle cadre, List<Rectangle> prises) {
        List<Integer> xs = new ArrayList<>(Arrays.asList(cadre.x + cadre.width, ecran.x + ecran.width - taille.width,
                ecran.x));
        List<Integer> ys = new ArrayList<>(Arrays.asList(cadre.y, ecran.y, ecran.y + ecran.height - taille.height));
        for (Rectangle prise : prises) {
            xs.addAll(Arrays.asList(prise.x, prise.x - taille.width, prise.x + prise.width));
            ys.addAll(Arrays.asList(prise.y + prise.height, prise.y - taille.height));
        }
        Point meilleure = ecran.getLocation();
        double moindre = Double.POSITIVE_INFINITY;
        for (int x : xs) {
            for (int y : ys) {
                Rectangle place = new Rectangle(new Point(x, y), taille);
                double cache = aire(place.intersection(cadre))
                        + aire(ecran) * prises.stream().mapToDouble(p -> aire(place.intersection(p))).sum();
                if (ecran.contains(place) && cache < moindre) {
                    meilleure = place.getLocation();
                    moindre = cache;
                }
            }
        }
        return meilleure;
    }

    private static double aire(Rectangle r) {
        return r.isEmpty() ? 0 : (double) r.width * r.height;
    }

    private static int lettreLibre(JMenu menu, String nom) {
        for (char c : nom.toCharArray()) {
            int touche = KeyEvent.getExtendedKeyCodeForChar(c);
            boolean libre = Character.isLetterOrDigit(c) && touche < 128;
            for (int k = 0; k < menu.getItemCount() && libre; k++) {
                libre = menu.getItem(k) == null || menu.getItem(k).getMnemonic() != touche;
            }
            if (libre) {
                return touche;
            }
        }
        return KeyEvent.VK_UNDEFINED;
    }
}
