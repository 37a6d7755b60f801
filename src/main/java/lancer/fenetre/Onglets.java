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
import javax.swing.SwingUtilities;

/** Les onglets à droite de l'image. Le contenu d'un onglet est créé quand il est demandé. */
@SuppressWarnings("serial")
final class Onglets extends JSplitPane {

    private static final int LARGEUR = 430;
    private static final int BARRE = 6;

    private final JFrame cadre;
    private final Map<String, Supplier<JComponent>> contenus;
    /** Les onglets, créés à la première demande. */
    private JTabbedPane onglets;
    /** Largeur du panneau à sa dernière ouverture, et largeur que le cadre y a gagnée. */
    private int largeur = Math.min(LARGEUR, getLargeurMax());
    private int gagne;

    /** @param image composant de gauche, toujours visible @param contenus contenu de chaque onglet, dans l'ordre */
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
        JTabbedPane faits = new JTabbedPane();
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
        // FlatLaf place ce composant au bout des onglets
        faits.putClientProperty("JTabbedPane.trailingComponent", bout);
        contenus.keySet().forEach(nom -> faits.addTab(nom, new JPanel(new BorderLayout())));
        faits.addChangeListener(e -> remplir());
        return faits;
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

    /** Le contenu de l'onglet montré, s'il est de cette classe ; {@code null} sinon. */
    <T extends JComponent> T getVisible(Class<T> classe) {
        JComponent onglet = estOuvert() ? (JComponent) onglets.getSelectedComponent() : null;
        return onglet == null || onglet.getComponentCount() == 0 || !classe.isInstance(onglet.getComponent(0))
                || !onglet.getComponent(0).isShowing() ? null : classe.cast(onglet.getComponent(0));
    }

    /** Montre cet onglet. Le cadre s'élargit vers la droite si l'écran le permet ; l'image ne se déplace pas. */
    JComponent montrer(int rang) {
        onglets = onglets == null ? faire() : onglets;
        onglets.setSelectedIndex(rang);
        if (!estOuvert()) {
            // l'apparence a pu changer pendant que le panneau était fermé
            SwingUtilities.updateComponentTreeUI(onglets);
            setRightComponent(onglets);
            setDividerSize(BARRE);
            gagne = 0;
            elargir(largeur + BARRE, largeur);
            remplir();
            ajuster();
        }
        return (JComponent) ((JComponent) onglets.getSelectedComponent()).getComponent(0);
    }

    /** La plus grande largeur du panneau quand il s'ouvre : deux cinquièmes de l'écran. */
    static int getLargeurMax() {
        return 2 * Dialogues.ecran().width / 5;
    }

    /** Donne au panneau ouvert la largeur que demande sa plus longue ligne, si elle manque. */
    void ajuster() {
        int voulue = Math.min(getLargeurMax(), onglets.getPreferredSize().width);
        if (voulue > onglets.getWidth()) {
            elargir(voulue - onglets.getWidth(), voulue);
        }
    }

    private void elargir(int manque, int voulue) {
        Rectangle ecran = Dialogues.ecran();
        boolean libre = cadre.getExtendedState() == Frame.NORMAL && cadre.isDisplayable() && !cadre.isUndecorated();
        int plus = !libre ? 0 : Math.max(0, Math.min(manque, ecran.x + ecran.width - cadre.getX() - cadre.getWidth()));
        gagne += plus;
        cadre.setSize(cadre.getWidth() + plus, cadre.getHeight());
        cadre.validate();
        setDividerLocation(getWidth() - voulue - BARRE);
        validate();
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
