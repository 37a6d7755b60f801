package lancer.fenetre.vue;

import java.awt.Color;
import java.awt.Component;
import java.awt.FlowLayout;
import java.awt.Graphics;
import java.util.Collections;
import java.util.List;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import lancer.fenetre.etat.Etat;
import lancer.image.ImageMemoire;
import lancer.image.ImageMemoire.Teinte;

/** La légende d'une vue : ses teintes, et leurs nombres. */
@SuppressWarnings("serial")
final class Legende extends JPanel implements Vue {

    private static final int ECART = 8;

    private List<Teinte> montrees = Collections.emptyList();

    Legende() {
        super(new FlowLayout(FlowLayout.TRAILING, ECART, 0));
        setName("legende");
        setVisible(false);
    }

    @Override
    public void montrer(Etat etat) {
        ImageMemoire image = etat.getVisible() == null ? null : etat.getVisible().image;
        List<Teinte> teintes = image == null ? montrees : image.teintes;
        if (teintes != montrees) {
            montrees = teintes;
            removeAll();
            teintes.forEach(teinte -> add(new JLabel(teinte.mot, new Pastille(new Color(teinte.couleur.getCode())),
                    JLabel.LEADING)));
            setToolTipText(image == null ? null : image.echelle);
            getAccessibleContext().setAccessibleDescription(getToolTipText());
            setVisible(!teintes.isEmpty());
            revalidate();
        }
    }

    /** Un carré de cette teinte, à la hauteur des textes. */
    private static final class Pastille implements Icon {

        private final Color teinte;

        Pastille(Color teinte) {
            this.teinte = teinte;
        }

        @Override
        public void paintIcon(Component composant, Graphics g, int x, int y) {
            g.setColor(teinte);
            g.fillRect(x, y, getIconWidth(), getIconHeight());
            g.setColor(composant.getForeground());
            g.drawRect(x, y, getIconWidth() - 1, getIconHeight() - 1);
        }

        @Override
        public int getIconWidth() {
            return 2 * ECART;
        }

        @Override
        public int getIconHeight() {
            return ECART + 2;
        }
    }
}
