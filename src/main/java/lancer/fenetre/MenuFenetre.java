package lancer.fenetre;

import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;

/** Les menus, et les touches qui vont avec. */
final class MenuFenetre extends JMenuBar {

    private static final long serialVersionUID = 1;

    MenuFenetre(Fenetre fenetre) {
        // Ctrl, ou Commande sur un Mac ; la forme en Ex est de Java 10
        int ctrl = Toolkit.getDefaultToolkit().getMenuShortcutKeyMask();
        JMenu fichier = menu("Fichier", KeyEvent.VK_F);
        article(fichier, "Ouvrir une scène…", KeyEvent.VK_O, ctrl, fenetre::choisirScene);
        article(fichier, "Enregistrer l'image…", KeyEvent.VK_S, ctrl, fenetre::enregistrer);
        fichier.addSeparator();
        article(fichier, "Quitter", KeyEvent.VK_Q, ctrl, fenetre::fermer);
        JMenu dessin = menu("Dessin", KeyEvent.VK_D);
        article(dessin, "Relire la scène et redessiner", KeyEvent.VK_F5, 0, fenetre::recharger);
        // la touche est liée par la fenêtre : Java l'afficherait « Escape »
        article(dessin, "Arrêter (Échap)", fenetre::arreter);
    }

    private JMenu menu(String nom, int touche) {
        JMenu menu = new JMenu(nom);
        menu.setMnemonic(touche);
        return add(menu);
    }

    private static void article(JMenu menu, String nom, int touche, int avec, Runnable action) {
        article(menu, nom, action).setAccelerator(KeyStroke.getKeyStroke(touche, avec));
    }

    private static JMenuItem article(JMenu menu, String nom, Runnable action) {
        JMenuItem article = new JMenuItem(nom);
        article.addActionListener(e -> action.run());
        return menu.add(article);
    }
}
