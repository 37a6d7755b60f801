package lancer.fenetre;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Rectangle;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;

/** Les onglets à droite de l'image, créés quand l'un d'eux est demandé. */
@SuppressWarnings("serial")
final class Onglets extends JSplitPane {

    static final int PIXEL = 0;
    static final int REGLAGES = 1;
    static final int VITESSE = 2;

    private static final int LARGEUR = 430;
    private static final int BARRE = 6;
    /** La plus petite hauteur du cadre qui laisse lire chaque onglet. */
    private static final int[] HAUTEURS = {300, 300, 480};

    private final JFrame cadre;
    private final Controleur controleur;
    private final JTabbedPane onglets = new JTabbedPane();
    /** La taille du cadre avant l'ouverture du panneau. */
    private Dimension avant;

    /** @param image composant de gauche, toujours visible */
    Onglets(JFrame cadre, JComponent image, Controleur controleur) {
        super(HORIZONTAL_SPLIT, image, null);
        this.cadre = cadre;
        this.controleur = controleur;
        setBorder(null);
        setResizeWeight(1);
        setFocusable(false);
        setDividerSize(0);
        onglets.setName("panneau");
        onglets.setFocusable(false);
        onglets.addChangeListener(e -> controleur.avertir());
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
            onglets.addTab("Pixel", new Inspecteur(controleur));
            onglets.addTab("Réglages", new PanneauReglages(controleur));
            onglets.addTab("Vitesse", new PanneauVitesse(controleur));
        }
        onglets.setSelectedIndex(rang);
        boolean ouvert = estOuvert();
        int large = ouvert ? 0 : BARRE + Math.min(LARGEUR, 2 * Dialogues.ecran().width / 5);
        if (!ouvert) {
            avant = cadre.getSize();
            setRightComponent(onglets);
            setDividerSize(BARRE);
        }
        if (cadre.getExtendedState() == Frame.NORMAL) {
            Rectangle ecran = Dialogues.ecran();
            Rectangle place = cadre.getBounds();
            place.width = Math.max(place.width, Math.min(place.width + large, ecran.x + ecran.width - place.x));
            place.height = Math.max(place.height, Math.min(HAUTEURS[rang], ecran.height));
            // plus haut s'il le faut pour tenir dans l'écran
            place.y = Math.min(place.y, ecran.y + ecran.height - place.height);
            cadre.setBounds(place);
        }
        cadre.validate();
        if (!ouvert) {
            setDividerLocation(getWidth() - large);
            validate();
            controleur.avertir();
        }
        return onglets.getSelectedComponent();
    }

    /** Cache le panneau. Le cadre reprend la taille qu'il avait. */
    void fermer() {
        if (estOuvert()) {
            setRightComponent(null);
            setDividerSize(0);
            if (cadre.getExtendedState() == Frame.NORMAL) {
                cadre.setSize(avant);
            }
            cadre.validate();
            getLeftComponent().transferFocus();
            controleur.avertir();
        }
    }
}
