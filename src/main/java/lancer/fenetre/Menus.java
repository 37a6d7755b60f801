package lancer.fenetre;

import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;

/** Création des menus. Chaque article a une lettre que les autres articles de son menu n'ont pas. */
final class Menus {

    private Menus() {
    }

    static JMenu menu(String nom) {
        JMenu menu = new JMenu(nom);
        menu.setMnemonic(nom.charAt(0));
        return menu;
    }

    /** La combinaison de Ctrl, ou de Commande sur un Mac, et de cette touche. */
    static KeyStroke ctrl(int touche) {
        // getMenuShortcutKeyMaskEx n'existe que depuis Java 10
        return KeyStroke.getKeyStroke(touche, Toolkit.getDefaultToolkit().getMenuShortcutKeyMask());
    }

    static KeyStroke touche(int touche) {
        return KeyStroke.getKeyStroke(touche, 0);
    }

    /** @param touche son raccourci, ou {@code null} */
    static JMenuItem article(JMenu menu, String nom, KeyStroke touche, Runnable action) {
        return article(menu, new JMenuItem(nom), touche, action);
    }

    static JRadioButtonMenuItem choix(JMenu menu, ButtonGroup groupe, String nom, KeyStroke touche, Runnable action) {
        JRadioButtonMenuItem choix = article(menu, new JRadioButtonMenuItem(nom), touche, action);
        groupe.add(choix);
        return choix;
    }

    /** Lie une touche à une action sans article. Liée à la racine du cadre, la touche manquerait à un menu ouvert. */
    static void lier(JFrame cadre, KeyStroke touche, Runnable action) {
        JComponent contenu = (JComponent) cadre.getContentPane();
        contenu.registerKeyboardAction(e -> action.run(), touche, JComponent.WHEN_IN_FOCUSED_WINDOW);
    }

    /** Ajoute un article, grisé tant qu'aucune scène n'est montrée. */
    static void siScene(Controleur controleur, JMenu menu, String nom, KeyStroke touche, Runnable action) {
        siScene(controleur, article(menu, nom, touche, action));
    }

    static <T extends JMenuItem> T siScene(Controleur controleur, T article) {
        article.setEnabled(false);
        controleur.prevenir(() -> article.setEnabled(controleur.reglages != null));
        return article;
    }

    static <T extends JMenuItem> T article(JMenu menu, T article, KeyStroke touche, Runnable action) {
        // un nom de fichier qui commence par <html> doit être affiché tel quel
        article.putClientProperty("html.disable", true);
        article.updateUI();
        article.setMnemonic(lettreLibre(menu, article.getText()));
        article.setAccelerator(touche);
        article.addActionListener(e -> action.run());
        menu.add(article);
        return article;
    }

    private static int lettreLibre(JMenu menu, String nom) {
        return nom.chars().filter(c -> c < 128 && Character.isLetterOrDigit(c)).map(KeyEvent::getExtendedKeyCodeForChar)
                .filter(lettre -> Arrays.stream(menu.getMenuComponents()).noneMatch(autre -> autre instanceof JMenuItem
                        && ((JMenuItem) autre).getMnemonic() == lettre)).findFirst().orElse(KeyEvent.VK_UNDEFINED);
    }
}
