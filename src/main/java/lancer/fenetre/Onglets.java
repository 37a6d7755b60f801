package lancer.fenetre;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Rectangle;
import java.util.Map;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;

/** Les onglets à droite de l'image. Le contenu d'un onglet est créé quand il est demandé. */
@SuppressWarnings("serial")
final class Onglets extends JSplitPane {

    private static final int LARGEUR = 430;
    private static final int BARRE = 6;
    /** La plus petite hauteur du cadre qui laisse lire chaque onglet. */
    private static final int[] HAUTEURS = {300, 300, 480};

    private final JFrame cadre;
    private final Runnable siChange;
    private final JTabbedPane onglets = new JTabbedPane();
    private final Supplier<Map<String, JComponent>> contenus;
    private final int largeur = Math.min(LARGEUR, 2 * Dialogues.ecran().width / 5);
    /** Ce que le cadre a gagné depuis l'ouverture du panneau. */
    private final Dimension gagne = new Dimension();

    /**
     * @param image composant de gauche, toujours visible
     * @param contenus crée les onglets, par nom, quand le panneau s'ouvre pour la première fois
     * @param siChange appelé quand le panneau s'ouvre ou se ferme
     */
    Onglets(JFrame cadre, JComponent image, Supplier<Map<String, JComponent>> contenus, Runnable siChange) {
        super(HORIZONTAL_SPLIT, image, null);
        this.cadre = cadre;
        this.contenus = contenus;
        this.siChange = siChange;
        setBorder(null);
        setResizeWeight(1);
        setFocusable(false);
        setDividerSize(0);
        onglets.setName("panneau");
        onglets.setFocusable(false);
    }

    boolean estOuvert() {
        return getRightComponent() != null;
    }

    /** L'onglet montré, s'il est de cette classe ; {@code null} sinon. */
    <T extends JComponent> T getVisible(Class<T> classe) {
        Component onglet = estOuvert() ? onglets.getSelectedComponent() : null;
        return classe.isInstance(onglet) && onglet.isShowing() ? classe.cast(onglet) : null;
    }

    /** Montre cet onglet. Le cadre s'élargit vers la droite si l'écran le permet ; l'image ne se déplace pas. */
    Component montrer(int rang) {
        if (onglets.getTabCount() == 0) {
            contenus.get().forEach(onglets::addTab);
        }
        onglets.setSelectedIndex(rang);
        if (!estOuvert()) {
            setRightComponent(onglets);
            setDividerSize(BARRE);
            agrandir(largeur + BARRE, HAUTEURS[rang] - cadre.getHeight());
            setDividerLocation(getWidth() - largeur - BARRE);
            validate();
            siChange.run();
        } else {
            agrandir(0, HAUTEURS[rang] - cadre.getHeight());
        }
        return onglets.getSelectedComponent();
    }

    /** Agrandit le cadre d'autant de points, si l'écran le permet. */
    private void agrandir(int enLargeur, int enHauteur) {
        if (cadre.getExtendedState() == Frame.NORMAL) {
            Rectangle ecran = Dialogues.ecran();
            int large = Math.max(0, Math.min(enLargeur, ecran.x + ecran.width - cadre.getX() - cadre.getWidth()));
            int haut = Math.max(0, Math.min(enHauteur, ecran.height - cadre.getHeight()));
            // plus haut s'il le faut pour tenir dans l'écran
            int bas = ecran.y + ecran.height - cadre.getHeight() - haut;
            cadre.setBounds(cadre.getX(), Math.min(cadre.getY(), bas), cadre.getWidth() + large,
                    cadre.getHeight() + haut);
            gagne.setSize(gagne.width + large, gagne.height + haut);
        }
        cadre.validate();
    }

    void fermer() {
        if (estOuvert()) {
            setRightComponent(null);
            setDividerSize(0);
            if (cadre.getExtendedState() == Frame.NORMAL) {
                cadre.setSize(cadre.getWidth() - gagne.width, cadre.getHeight() - gagne.height);
            }
            gagne.setSize(0, 0);
            cadre.validate();
            getLeftComponent().transferFocus();
            siChange.run();
        }
    }
}
