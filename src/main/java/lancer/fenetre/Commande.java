package lancer.fenetre;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.function.BooleanSupplier;
import javax.swing.AbstractAction;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;

/** Une commande de la fenêtre : son nom, sa touche, quand elle est possible, quand elle est cochée, ce qu'elle fait. */
@SuppressWarnings("serial")
final class Commande extends AbstractAction {

    private final BooleanSupplier possible;
    private final Runnable effet;
    private BooleanSupplier cochee;

    /** @param touche comme l'écrit {@link KeyStroke}, ou {@code null} ; sur un Mac, {@code ctrl} est Commande */
    Commande(String nom, String touche, BooleanSupplier possible, Runnable effet) {
        super(nom);
        this.possible = possible;
        this.effet = effet;
        boolean mac = Toolkit.getDefaultToolkit().getMenuShortcutKeyMask() == InputEvent.META_MASK;
        if (touche != null) {
            putValue(ACCELERATOR_KEY, KeyStroke.getKeyStroke(mac ? touche.replace("ctrl", "meta") : touche));
        }
    }

    /** La touche de cette commande sert dans ce composant. @param quand une des conditions de {@link JComponent} */
    void lier(JComponent composant, int quand) {
        composant.getInputMap(quand).put(getTouche(), this);
        composant.getActionMap().put(this, this);
    }

    /** Son article porte une coche tant que {@code condition} est vraie. */
    Commande cochee(BooleanSupplier condition) {
        cochee = condition;
        putValue(SELECTED_KEY, condition.getAsBoolean());
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
        return avec + (avec.isEmpty() ? "" : "+") + KeyEvent.getKeyText(touche.getKeyCode());
    }

    @Override
    public boolean isEnabled() {
        return possible.getAsBoolean();
    }

    /** Grise et coche son article de menu comme le veut l'état de la fenêtre. */
    void ajuster() {
        firePropertyChange("enabled", null, isEnabled());
        if (cochee != null) {
            putValue(SELECTED_KEY, cochee.getAsBoolean());
        }
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        effet.run();
        ajuster();
    }
}
