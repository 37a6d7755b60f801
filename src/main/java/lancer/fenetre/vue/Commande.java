package lancer.fenetre.vue;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.AbstractAction;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import lancer.fenetre.etat.Etat;

/** Une commande de la fenêtre : son nom, ses touches, quand elle est possible, ou cochée, et ce qu'elle fait. */
@SuppressWarnings("serial")
final class Commande extends AbstractAction implements Vue {

    private final List<KeyStroke> touches;
    private final Predicate<Etat> possible;
    private final Predicate<Etat> cochee;
    private final Runnable effet;

    /**
     * @param touches comme les écrit {@link KeyStroke}, la première étant celle qui se dit ; sur un Mac, {@code ctrl}
     *     est Commande, et {@code AGRAVE} est la touche à/0 d'un clavier français
     * @param cochee {@code null} si son article ne porte pas de coche
     */
    Commande(String nom, String touches, Predicate<Etat> possible, Predicate<Etat> cochee, Runnable effet) {
        super(nom);
        this.possible = possible;
        this.cochee = cochee;
        this.effet = effet;
        boolean mac = Toolkit.getDefaultToolkit().getMenuShortcutKeyMask() == InputEvent.META_MASK;
        this.touches = Stream.of((mac ? touches.replace("ctrl", "meta") : touches).split(", "))
                .map(Commande::lire).collect(Collectors.toList());
        putValue(ACCELERATOR_KEY, getTouche());
        if (cochee != null) {
            putValue(SELECTED_KEY, false);
        }
    }

    private static KeyStroke lire(String touche) {
        return !touche.endsWith("AGRAVE") ? KeyStroke.getKeyStroke(touche)
                : KeyStroke.getKeyStroke(KeyEvent.getExtendedKeyCodeForChar('à'),
                KeyStroke.getKeyStroke(touche.replace("AGRAVE", "0")).getModifiers());
    }

    /** Ses touches servent dans ce composant. @param quand une des conditions de {@link JComponent} */
    Commande lier(JComponent composant, int quand) {
        touches.forEach(touche -> composant.registerKeyboardAction(this, touche, quand));
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

    /** Sa première touche, ou {@code null}. */
    KeyStroke getTouche() {
        return touches.get(0);
    }

    private boolean estUnSigne() {
        return getTouche() != null && getTouche().getKeyCode() == KeyEvent.VK_UNDEFINED;
    }

    /** La touche, en français, par exemple « Ctrl+Haut ». */
    String direTouche() {
        String avec = InputEvent.getModifiersExText(getTouche().getModifiers());
        return avec + (avec.isEmpty() ? "" : "+")
                + (estUnSigne() ? "" + getTouche().getKeyChar() : KeyEvent.getKeyText(getTouche().getKeyCode()));
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
        // Swing donne un signe frappé avec Ctrl à la commande de ce signe
        if (!estUnSigne() || (e.getModifiers() & (ActionEvent.CTRL_MASK | ActionEvent.META_MASK)) == 0) {
            effet.run();
        }
    }
}
