package lancer.fenetre;

import java.awt.Dimension;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JScrollPane;
import javax.swing.JTable;

/** Le tableau des touches, qui reste ouvert à côté pendant qu'on les essaie. */
final class Touches extends JDialog {

    private static final long serialVersionUID = 1;

    private static final int MARGE = 16;

    private static final String[][] TOUCHES = {
        {"Ctrl+O", "ouvrir une scène ; ou déposer son fichier sur la fenêtre"},
        {"Page suivante, précédente", "les autres scènes du dossier"},
        {"Ctrl+S, Ctrl+C", "enregistrer l'image, la copier"},
        {"+, −", "plus ou moins de réflexions"},
        {"F2", "les paramètres des variantes"},
        {"F3", "vitesse ou précision : les réglages possibles, à dessiner d'un clic"},
        {"Espace, tenue", "l'image d'avant"},
        {"Ctrl+Maj+C", "copier les réglages"},
        {"Ctrl+1, Ctrl+0, F11", "taille demandée, remplir la fenêtre, plein écran"},
        {"molette, Ctrl+Haut, Ctrl+Bas", "loupe ; la tirer la déplace"},
        {"un clic, Entrée", "les rayons du pixel"},
        {"flèches", "le pixel voisin ; avec Maj, de dix en dix"},
        {"1 à 9, 0", "un rebond seul dans les figures, tous ; ou un clic sur son numéro"},
        {"D", "déplier ou replier le détail du pixel"},
        {"Ctrl+Page suivante, précédente", "un autre échantillon du pixel"},
        {"F5", "relire la scène et redessiner ; l'enregistrer dans un éditeur le fait aussi"},
        {"Échap", "arrêter le dessin ; sinon, fermer ce qui est à côté, ou le plein écran"},
        {"F10", "les menus"},
        {"Ctrl+Q", "quitter"},
        {"F1", "ces touches"},
    };

    Touches(JFrame cadre) {
        super(cadre, "Touches");
        setName("touches");
        JTable table = new JTable(TOUCHES, new String[] {"touche", "effet"});
        table.setName("table");
        // les touches essayées d'ici vont au cadre
        table.setFocusable(false);
        table.setEnabled(false);
        table.setRowHeight(table.getFontMetrics(table.getFont()).getHeight() + 4);
        for (int colonne = 0; colonne < 2; colonne++) {
            int large = 0;
            for (String[] ligne : TOUCHES) {
                large = Math.max(large, table.getFontMetrics(table.getFont()).stringWidth(ligne[colonne]) + MARGE);
            }
            table.getColumnModel().getColumn(colonne).setPreferredWidth(large);
        }
        Dimension taille = table.getPreferredSize();
        table.setPreferredScrollableViewportSize(taille);
        add(new JScrollPane(table));
        pack();
    }
}
