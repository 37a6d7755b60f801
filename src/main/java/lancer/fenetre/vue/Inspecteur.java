package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.UIManager;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreeCellRenderer;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Explication.Faite;
import lancer.fenetre.etat.Suite;
import lancer.fenetre.vue.figures.VueDeCote;
import lancer.inspection.Recit.Noeud;

/** L'explication d'un pixel, et les nombres de ce qui s'y voit. */
@SuppressWarnings("serial")
final class Inspecteur extends JPanel implements Vue {

    private static final int MARGE = 6;
    private static final int PASTILLE = 10;
    private static final int HAUTEUR_VUE = 190;

    private final JTree arbre = new JTree(new DefaultTreeModel(null));
    private final Etiquette verdict = new Etiquette("verdict");
    private final VueDeCote vue = new VueDeCote();
    private final ChampsDeSection champs;
    private Etat etat;

    Inspecteur(Consumer<Suite.Evenement> recevoir) {
        super(new BorderLayout(MARGE, MARGE));
        champs = new ChampsDeSection(recevoir);
        setName("pixel");
        setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        arbre.setName("recit");
        arbre.getAccessibleContext().setAccessibleName("chaîne du pixel");
        arbre.setToggleClickCount(1);
        // un clic laisse le clavier à l'image : les flèches y déplacent le pixel
        arbre.setRequestFocusEnabled(false);
        arbre.setRowHeight(0);
        arbre.setCellRenderer(new Ligne());
        JScrollPane deroulant = new JScrollPane(arbre, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED,
                JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        deroulant.getViewport().addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                // un autre peintre : la hauteur de chaque ligne est calculée de nouveau
                arbre.setCellRenderer(new Ligne());
            }
        });
        vue.setPreferredSize(new Dimension(0, HAUTEUR_VUE));
        JSplitPane partage = new JSplitPane(JSplitPane.VERTICAL_SPLIT, deroulant, vue);
        // un écran dense n'a parfois que quatre cents points de haut
        vue.setMinimumSize(new Dimension(0, HAUTEUR_VUE / 2));
        partage.setResizeWeight(0.6);
        partage.setBorder(null);
        partage.setFocusable(false);
        JPanel haut = new JPanel(new BorderLayout(MARGE, MARGE));
        haut.add(champs, BorderLayout.PAGE_START);
        haut.add(verdict, BorderLayout.CENTER);
        add(haut, BorderLayout.PAGE_START);
        add(partage, BorderLayout.CENTER);
    }

    @Override
    public void montrer(Etat nouveau) {
        champs.montrer(nouveau);
        verdict.setText(nouveau.explication.direLeVerdict(nouveau.getImageEntiere()));
        // grisée pendant le calcul
        arbre.setEnabled(!nouveau.explication.enCours());
        Faite faite = nouveau.explication.faite;
        boolean autre = etat == null || faite != etat.explication.faite;
        if (autre) {
            arbre.setModel(new DefaultTreeModel(faite == null || faite.recit == null ? null : branche(faite.recit)));
            vue.montrer(faite == null ? null : faite.inspection);
        }
        if (autre || nouveau.ecran.tout != etat.ecran.tout) {
            ouvrir(nouveau.ecran.tout);
        }
        etat = nouveau;
    }

    private static DefaultMutableTreeNode branche(Noeud noeud) {
        DefaultMutableTreeNode branche = new DefaultMutableTreeNode(noeud);
        noeud.enfants.forEach(enfant -> branche.add(branche(enfant)));
        return branche;
    }

    private static Noeud noeud(Object branche) {
        return (Noeud) ((DefaultMutableTreeNode) branche).getUserObject();
    }

    /** Déplie tout le détail, ou l'essentiel. */
    private void ouvrir(boolean tout) {
        // ouvrir un nœud ajoute des lignes après la sienne
        for (int r = 0; r < arbre.getRowCount(); r++) {
            if (tout || !noeud(arbre.getPathForRow(r).getLastPathComponent()).replie) {
                arbre.expandRow(r);
            } else {
                arbre.collapseRow(r);
            }
        }
    }

    /** Une ligne de l'arbre : une pastille de sa couleur, et son texte, continué au-dessous s'il est long. */
    private final class Ligne extends JTextArea implements TreeCellRenderer {

        private final int retrait = UIManager.getInt("Tree.leftChildIndent")
                + UIManager.getInt("Tree.rightChildIndent");

        Ligne() {
            setLineWrap(true);
            setWrapStyleWord(true);
            setFont(arbre.getFont());
        }

        @Override
        public Component getTreeCellRendererComponent(JTree tree, Object branche, boolean choisi, boolean ouvert,
                boolean feuille, int ligne, boolean clavier) {
            Noeud noeud = noeud(branche);
            setText(Etiquette.lier(noeud.texte));
            getAccessibleContext().setAccessibleName(noeud.texte);
            setEnabled(tree.isEnabled());
            setBackground(UIManager.getColor(clavier ? "Tree.selectionInactiveBackground" : "Tree.background"));
            setBorder(BorderFactory.createCompoundBorder(BorderFactory.createMatteBorder(2, 0, 1, 0, getBackground()),
                    noeud.couleur == null ? null : BorderFactory.createCompoundBorder(
                            BorderFactory.createMatteBorder(0, PASTILLE, 0, 0, new Color(noeud.couleur.getCode())),
                            BorderFactory.createEmptyBorder(0, MARGE, 0, 0))));
            int niveau = ((DefaultMutableTreeNode) branche).getLevel() + 1;
            // à cette largeur, la hauteur est celle de toutes les lignes de l'écran qu'il faut
            setSize(Math.max(20 * PASTILLE, arbre.getParent().getWidth() - niveau * retrait), Short.MAX_VALUE);
            return this;
        }
    }
}
