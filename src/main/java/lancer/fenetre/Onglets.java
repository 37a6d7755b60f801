package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Frame;
import java.awt.Rectangle;
import java.util.Map;
import java.util.function.Supplier;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.LookAndFeel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;

/** Le panneau à droite de l'image : un onglet pour chaque question. Le contenu d'un onglet est fait à sa demande. */
@SuppressWarnings("serial")
final class Onglets extends JSplitPane {

    static final int LARGEUR = 430;
    private static final int BARRE = 6;

    private final JFrame cadre;
    private final Map<String, Supplier<JComponent>> contenus;
    /** Les onglets, faits quand l'un d'eux est demandé, et l'apparence qu'ils ont. */
    private JTabbedPane onglets;
    private LookAndFeel apparence;
    /** Largeur du panneau la dernière fois qu'il était ouvert, et ce que le cadre y a gagné. */
    private int largeur = LARGEUR;
    private int gagne;

    /** @param image ce qui est toujours à gauche @param contenus ce que montre chaque onglet, dans l'ordre */
    Onglets(JFrame cadre, JComponent image, Map<String, Supplier<JComponent>> contenus) {
        super(HORIZONTAL_SPLIT, image, null);
        this.cadre = cadre;
        this.contenus = contenus;
        setBorder(null);
        setResizeWeight(1);
        setFocusable(false);
        setDividerSize(0);
    }

    private JTabbedPane faire() {
        JTabbedPane faits = new JTabbedPane() {
            @Override
            public void updateUI() {
                super.updateUI();
                SwingUtilities.replaceUIInputMap(this, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, null);
            }
        };
        faits.setName("panneau");
        faits.setFocusable(false);
        JButton fermer = new JButton("×");
        fermer.setToolTipText("fermer le panneau (Échap)");
        fermer.setFocusable(false);
        fermer.addActionListener(e -> fermer());
        fermer.putClientProperty("JButton.buttonType", "toolBarButton");
        Box bout = Box.createHorizontalBox();
        bout.add(Box.createHorizontalGlue());
        bout.add(fermer);
        // FlatLaf le pose au bout des onglets
        faits.putClientProperty("JTabbedPane.trailingComponent", bout);
        contenus.keySet().forEach(nom -> faits.addTab(nom, new JPanel(new BorderLayout())));
        faits.addChangeListener(e -> remplir());
        return faits;
    }

    /** Les flèches et Ctrl sont pour l'image, non pour passer d'un onglet à l'autre ou déplacer la séparation. */
    @Override
    public void updateUI() {
        super.updateUI();
        SwingUtilities.replaceUIInputMap(this, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, null);
    }

    private void remplir() {
        JComponent onglet = (JComponent) onglets.getSelectedComponent();
        if (estOuvert() && onglet.getComponentCount() == 0) {
            onglet.add(contenus.get(onglets.getTitleAt(onglets.getSelectedIndex())).get());
            onglet.validate();
        }
    }

    boolean estOuvert() {
        return getRightComponent() != null;
    }

    /** Montre cet onglet ; le cadre s'élargit vers la droite autant que l'écran le permet, l'image ne bouge pas. */
    JComponent montrer(int rang) {
        onglets = onglets == null ? faire() : onglets;
        onglets.setSelectedIndex(rang);
        if (!estOuvert()) {
            if (apparence != UIManager.getLookAndFeel()) {
                // changée pendant que le panneau était fermé
                apparence = UIManager.getLookAndFeel();
                SwingUtilities.updateComponentTreeUI(onglets);
            }
            Rectangle ecran = Dialogues.ecran();
            boolean libre = cadre.getExtendedState() == Frame.NORMAL && cadre.isDisplayable() && !cadre.isUndecorated();
            gagne = !libre ? 0 : Math.max(0, Math.min(largeur + BARRE,
                    ecran.x + ecran.width - cadre.getX() - cadre.getWidth()));
            setRightComponent(onglets);
            setDividerSize(BARRE);
            setDividerLocation(getWidth() - largeur - BARRE);
            cadre.validate();
            // ce que le cadre gagne, quand le bureau le lui donne, est pour l'image
            cadre.setSize(cadre.getWidth() + gagne, cadre.getHeight());
            cadre.validate();
            setDividerLocation(getWidth() - largeur - BARRE);
            remplir();
        }
        return (JComponent) ((JComponent) onglets.getSelectedComponent()).getComponent(0);
    }

    void fermer() {
        if (estOuvert()) {
            largeur = onglets.getWidth();
            setRightComponent(null);
            setDividerSize(0);
            if (cadre.getExtendedState() == Frame.NORMAL && !cadre.isUndecorated()) {
                cadre.setSize(cadre.getWidth() - gagne, cadre.getHeight());
            }
            cadre.validate();
            getLeftComponent().requestFocusInWindow();
        }
    }
}
