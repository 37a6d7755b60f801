package lancer.fenetre;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.KeyStroke;

/** Ce qu'on peut demander à la fenêtre, par un menu ou une touche. */
final class Commande extends AbstractAction {

    private static final long serialVersionUID = 1;

    private final transient Runnable action;

    /** @param touche celle que le menu montre et qui y équivaut, ou {@code null} */
    Commande(String nom, KeyStroke touche, Runnable action) {
        super(nom);
        putValue(ACCELERATOR_KEY, touche);
        this.action = action;
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        action.run();
    }
}
