package lancer.fenetre.vue;

import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Rectangle;
import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Onglet;
import lancer.fenetre.etat.Suite;

/** Les onglets à droite de l'image, créés quand l'un d'eux est demandé. */
@SuppressWarnings("serial")
final class Onglets extends JSplitPane implements Vue {

    private static final int LARGEUR = 430;
    private static final int BARRE = 6;
    private static final String[] NOMS = {"Pixel", "Réglages", "Vitesse"};
    /** La plus petite hauteur du cadre qui laisse lire chaque onglet. */
    private static final int[] HAUTEURS = {640, 300, 480};

    private final JFrame cadre;
    private final Map<Onglet, Supplier<JComponent>> fabriques;
    private final Map<Onglet, JComponent> faits = new EnumMap<>(Onglet.class);
    private final JTabbedPane onglets = new JTabbedPane();
    /** La taille du cadre avant l'ouverture du panneau. */
    private Dimension avant;

    /** @param image composant de gauche, toujours visible @param fabriques font chaque onglet, une {@link Vue} */
    Onglets(JFrame cadre, JComponent image, Map<Onglet, Supplier<JComponent>> fabriques,
            Consumer<Suite.Evenement> recevoir) {
        super(HORIZONTAL_SPLIT, image, null);
        this.cadre = cadre;
        this.fabriques = fabriques;
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

    @Override
    public void montrer(Etat etat) {
        Onglet voulu = etat.ecran.onglet;
        if (voulu == null) {
            fermer();
            return;
        }
        if (faits.isEmpty()) {
            fabriques.forEach((onglet, fabrique) -> {
                faits.put(onglet, fabrique.get());
                onglets.addTab(NOMS[onglet.ordinal()], faits.get(onglet));
            });
        }
        boolean ouvert = getRightComponent() != null;
        boolean autre = !ouvert || onglets.getSelectedIndex() != voulu.ordinal();
        onglets.setSelectedIndex(voulu.ordinal());
        ((Vue) faits.get(voulu)).montrer(etat);
        if (autre) {
            placer(voulu, ouvert);
        }
    }

    /** Le cadre s'élargit vers la droite si l'écran le permet ; l'image ne se déplace pas. */
    private void placer(Onglet voulu, boolean ouvert) {
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
            place.height = Math.max(place.height, Math.min(HAUTEURS[voulu.ordinal()], ecran.height));
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

    /** Donne le clavier au premier composant de cet onglet, montré. */
    void donnerLeClavier(Onglet onglet) {
        if (faits.containsKey(onglet)) {
            faits.get(onglet).transferFocus();
        }
    }

    /** Les onglets qui sont faits et ne se voient pas : une autre taille des textes les concerne aussi. */
    JComponent getCache() {
        return getRightComponent() == null ? onglets : null;
    }
}
