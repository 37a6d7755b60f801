package lancer.fenetre.vue;

import java.awt.Color;
import java.awt.FlowLayout;
import java.util.Collections;
import java.util.List;
import javax.swing.BorderFactory;
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
        if (image != null && image.teintes != montrees) {
            montrees = image.teintes;
            removeAll();
            montrees.forEach(teinte -> {
                JLabel mot = new JLabel(teinte.mot + " ");
                mot.setBorder(BorderFactory.createCompoundBorder(BorderFactory.createLineBorder(getForeground()),
                        Etiquette.pastille(teinte.couleur, 2 * ECART)));
                add(mot);
            });
            setToolTipText(image.echelle);
            getAccessibleContext().setAccessibleDescription(image.echelle);
            setVisible(!montrees.isEmpty());
            revalidate();
        }
    }
}
