package lancer.fenetre.vue;

import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Des lignes de composants, chacun après son nom. */
@SuppressWarnings("serial")
final class Grille extends JPanel {

    private static final int MARGE = 4;

    Grille() {
        super(new GridBagLayout());
    }

    /** Ajoute ce composant, de ce nom. @param fin vrai s'il est le dernier de sa ligne */
    void nommer(String nom, JComponent composant, boolean fin) {
        JLabel titre = new JLabel(nom);
        titre.setLabelFor(composant);
        poser(titre, 0, false);
        poser(composant, 1, fin);
    }

    /** @param part ce qu'il prend de la largeur qui reste, 0 ou 1 */
    void poser(JComponent composant, int part, boolean fin) {
        add(composant, new GridBagConstraints(GridBagConstraints.RELATIVE, GridBagConstraints.RELATIVE,
                fin ? GridBagConstraints.REMAINDER : 1, 1, part, 0, GridBagConstraints.LINE_START,
                GridBagConstraints.HORIZONTAL, new Insets(MARGE / 2, 0, 0, MARGE), 0, 0));
    }
}
