package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Frame;
import java.awt.Rectangle;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;

/** Les onglets à droite de l'image. Le contenu d'un onglet est créé quand il est demandé. */
@SuppressWarnings("serial")
final class Onglets extends JSplitPane {

    private static final int LARGEUR = 430;
    private static final int BARRE = 6;

    private final JFrame cadre;
    private final Runnable siChange;
    private final JTabbedPane onglets = new JTabbedPane();
    private final Map<JPanel, Supplier<JComponent>> contenus = new LinkedHashMap<>();
    /** Largeur du panneau à sa dernière ouverture, et largeur que le cadre y a gagnée. */
    private int largeur = Math.min(LARGEUR, 2 * Dialogues.ecran().width / 5);
    private int gagne;

    /** @param image composant de gauche, toujours visible @param siChange appelé quand le panneau s'ouvre ou se ferme */
    Onglets(JFrame cadre, JComponent image, Runnable siChange) {
        super(HORIZONTAL_SPLIT, image, null);
        this.cadre = cadre;
        this.siChange = siChange;
        setBorder(null);
        setResizeWeight(1);
        setFocusable(false);
        setDividerSize(0);
        onglets.setName("panneau");
        onglets.setFocusable(false);
        JButton fermer = new JButton("×");
        fermer.setToolTipText("fermer le panneau (Échap)");
        fermer.setFocusable(false);
        fermer.addActionListener(e -> fermer());
        fermer.putClientProperty("JButton.buttonType", "toolBarButton");
        Box bout = Box.createHorizontalBox();
        bout.add(Box.createHorizontalGlue());
        bout.add(fermer);
        // FlatLaf place ce composant au bout des onglets
        onglets.putClientProperty("JTabbedPane.trailingComponent", bout);
        onglets.addChangeListener(e -> remplir());
    }

    void ajouter(String nom, Supplier<JComponent> contenu) {
        JPanel onglet = new JPanel(new BorderLayout());
        contenus.put(onglet, contenu);
        onglets.addTab(nom, onglet);
    }

    private void remplir() {
        JPanel onglet = (JPanel) onglets.getSelectedComponent();
        if (estOuvert() && onglet.getComponentCount() == 0) {
            onglet.add(contenus.get(onglet).get());
            onglet.validate();
        }
    }

    boolean estOuvert() {
        return getRightComponent() != null;
    }

    /** Le contenu de l'onglet montré, s'il est de cette classe ; {@code null} sinon. */
    <T extends JComponent> T getVisible(Class<T> classe) {
        Object contenu = estOuvert() ? ((JPanel) onglets.getSelectedComponent()).getComponent(0) : null;
        return classe.isInstance(contenu) ? classe.cast(contenu) : null;
    }

    /** Montre cet onglet. Le cadre s'élargit vers la droite si l'écran le permet ; l'image ne se déplace pas. */
    JComponent montrer(int rang) {
        onglets.setSelectedIndex(rang);
        if (!estOuvert()) {
            setRightComponent(onglets);
            setDividerSize(BARRE);
            Rectangle ecran = Dialogues.ecran();
            int libre = ecran.x + ecran.width - cadre.getX() - cadre.getWidth();
            gagne = cadre.getExtendedState() == Frame.NORMAL ? Math.max(0, Math.min(largeur + BARRE, libre)) : 0;
            cadre.setSize(cadre.getWidth() + gagne, cadre.getHeight());
            cadre.validate();
            setDividerLocation(getWidth() - largeur - BARRE);
            remplir();
            validate();
            siChange.run();
        }
        return (JComponent) ((JPanel) onglets.getSelectedComponent()).getComponent(0);
    }

    void fermer() {
        if (estOuvert()) {
            largeur = onglets.getWidth();
            setRightComponent(null);
            setDividerSize(0);
            if (cadre.getExtendedState() == Frame.NORMAL) {
                cadre.setSize(cadre.getWidth() - gagne, cadre.getHeight());
            }
            cadre.validate();
            getLeftComponent().transferFocus();
            siChange.run();
        }
    }
}
