package lancer.fenetre.vue;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.function.Predicate;
import javax.swing.AbstractAction;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import lancer.fenetre.etat.Etat;

/** Une commande de la fenêtre : son nom, sa touche, quand elle est possible, quand elle est cochée, ce qu'elle fait. */
@SuppressWarnings("serial")
final class Commande extends AbstractAction implements Vue {

    private final Predicate<Etat> possible;
    private final Predicate<Etat> cochee;
    private final Runnable effet;

    /**
     * @param touche comme l'écrit {@link KeyStroke}, ou {@code null} ; sur un Mac, {@code ctrl} est Commande
     * @param cochee {@code null} si son article ne porte pas de coche
     */
    Commande(String nom, String touche, Predicate<Etat> possible, Predicate<Etat> cochee, Runnable effet) {
        super(nom);
        this.possible = possible;
        this.cochee = cochee;
        this.effet = effet;
        boolean mac = Toolkit.getDefaultToolkit().getMenuShortcutKeyMask() == InputEvent.META_MASK;
        if (touche != null) {
            putValue(ACCELERATOR_KEY, KeyStroke.getKeyStroke(mac ? touche.replace("ctrl", "meta") : touche));
        }
        if (cochee != null) {
            putValue(SELECTED_KEY, false);
        }
    }

    /** La touche de cette commande sert dans ce composant. @param quand une des conditions de {@link JComponent} */
    Commande lier(JComponent composant, int quand) {
        composant.getInputMap(quand).put(getTouche(), this);
        composant.getActionMap().put(this, this);
        return this;
    }

    /** Un article de menu de cette commande. Un nom de fichier qui commence par {@code <html>} y est écrit tel quel. */
    JMenuItem article() {
        JMenuItem article = cochee == null ? new JMenuItem() : new JCheckBoxMenuItem();
        article.putClientProperty("html.disable", true);
        article.setAction(this);
        return article;
    }

    String getNom() {
        return (String) getValue(NAME);
    }

    KeyStroke getTouche() {
        return (KeyStroke) getValue(ACCELERATOR_KEY);
    }

    /** La touche, en français, par exemple « Ctrl+Haut ». */
    String direTouche() {
        KeyStroke touche = getTouche();
        if (touche.getKeyCode() == KeyEvent.VK_UNDEFINED) {
            return String.valueOf(Character.toUpperCase(touche.getKeyChar()));
        }
        String avec = InputEvent.getModifiersExText(touche.getModifiers());
        return avec + (avec.isEmpty() ? "" : "+") + direSigne(touche.getKeyCode());
    }

    private static String direSigne(int touche) {
        switch (touche) {
            case KeyEvent.VK_PLUS:
            case KeyEvent.VK_ADD:
                return "+";
            case KeyEvent.VK_MINUS:
            case KeyEvent.VK_SUBTRACT:
                return "−";
            default:
                return KeyEvent.getKeyText(touche);
        }
    }

    /** Grise et coche son article de menu. */
    @Override
    public void montrer(Etat etat) {
        setEnabled(possible.test(etat));
        if (cochee != null) {
            putValue(SELECTED_KEY, cochee.test(etat));
        }
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        // Swing donne un caractère frappé avec Ctrl à la commande de ce caractère
        boolean caractere = getTouche() != null && getTouche().getKeyCode() == KeyEvent.VK_UNDEFINED;
        if (!caractere || (e.getModifiers() & (ActionEvent.CTRL_MASK | ActionEvent.META_MASK)) == 0) {
            effet.run();
        }
    }
}
