package lancer.fenetre.vue;

import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Onglet;
import lancer.fenetre.etat.Suite;

/** Les onglets à droite de l'image, créés quand l'un d'eux est demandé. */
@SuppressWarnings("serial")
final class Onglets extends JSplitPane implements Vue {

    private static final int LARGEUR = 430;
    private static final int BARRE = 6;

    private final JFrame cadre;
    private final Runnable fabrique;
    private final List<Vue> vues = new ArrayList<>();
    private final JTabbedPane onglets = new JTabbedPane();
    /** La taille du cadre avant l'ouverture du panneau. */
    private Dimension avant;

    /** @param image composant de gauche, toujours visible @param fabrique ajoute les onglets, dans leur ordre */
    Onglets(JFrame cadre, JComponent image, Runnable fabrique, Consumer<Suite.Evenement> recevoir) {
        super(HORIZONTAL_SPLIT, image, null);
        this.cadre = cadre;
        this.fabrique = fabrique;
        setBorder(null);
        setResizeWeight(1);
        setFocusable(false);
        setDividerSize(0);
        onglets.setName("panneau");
        onglets.setFocusable(false);
        onglets.addChangeListener(e -> {
            if (getRightComponent() != null) {
                Onglet choisi = Onglet.values()[onglets.getSelectedIndex()];
                recevoir.accept(suite -> suite.montrer(choisi));
            }
        });
    }

    /** @param hauteur la plus petite du cadre qui laisse le lire */
    <V extends JComponent & Vue> void ajouter(String nom, int hauteur, V onglet) {
        onglet.setPreferredSize(new Dimension(LARGEUR, hauteur));
        vues.add(onglet);
        onglets.addTab(nom, onglet);
    }

    @Override
    public void montrer(Etat etat) {
        Onglet voulu = etat.ecran.onglet;
        if (voulu == null) {
            fermer();
            return;
        }
        if (vues.isEmpty()) {
            fabrique.run();
        }
        boolean ouvert = getRightComponent() != null;
        boolean autre = !ouvert || onglets.getSelectedIndex() != voulu.ordinal();
        onglets.setSelectedIndex(voulu.ordinal());
        vues.get(voulu.ordinal()).montrer(etat);
        if (autre) {
            placer(ouvert);
        }
    }

    /** Le cadre s'élargit vers la droite si l'écran le permet ; l'image ne se déplace pas. */
    private void placer(boolean ouvert) {
        Rectangle ecran = Dialogues.ecran();
        int large = ouvert ? 0 : BARRE + Math.min(LARGEUR, 2 * ecran.width / 5);
        if (!ouvert) {
            avant = cadre.getSize();
            setRightComponent(onglets);
            setDividerSize(BARRE);
        }
        if (cadre.getExtendedState() == Frame.NORMAL) {
            Rectangle place = cadre.getBounds();
            place.width = Math.max(place.width, Math.min(place.width + large, ecran.x + ecran.width - place.x));
            place.height = Math.max(place.height,
                    Math.min(onglets.getSelectedComponent().getPreferredSize().height, ecran.height));
            // plus haut s'il le faut pour tenir dans l'écran
            place.y = Math.min(place.y, ecran.y + ecran.height - place.height);
            cadre.setBounds(place);
        }
        cadre.validate();
        if (!ouvert) {
            setDividerLocation(getWidth() - large);
            validate();
        }
    }

    /** Cache le panneau. Le cadre reprend la taille qu'il avait. */
    private void fermer() {
        if (getRightComponent() != null) {
            setRightComponent(null);
            setDividerSize(0);
            if (cadre.getExtendedState() == Frame.NORMAL) {
                cadre.setSize(avant);
            }
            cadre.validate();
            getLeftComponent().transferFocus();
        }
    }

    /** Donne le clavier au premier composant de l'onglet qui se voit. */
    void donnerLeClavier() {
        onglets.getSelectedComponent().transferFocus();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (onglets != null) {
            // même ceux qui ne se voient pas
            SwingUtilities.updateComponentTreeUI(onglets);
        }
    }
}
