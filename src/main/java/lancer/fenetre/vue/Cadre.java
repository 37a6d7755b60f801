package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.WindowEvent;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.UIManager;
import javax.swing.WindowConstants;
import lancer.fenetre.etat.Dialogue;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Suite;

/** Le cadre : l'image et les onglets, le titre, la ligne du bas. Une horloge y montre où en est le dessin en cours. */
@SuppressWarnings("serial")
public final class Cadre extends JFrame implements Vue {

    private static final int PERIODE_MS = 33;

    /** Le nom du programme et de ses variantes. */
    private final String nom;
    private final Consumer<Suite.Evenement> recevoir;
    private final PanneauImage image;
    private final BarreEtat barre;
    private final Onglets onglets;
    private final Dialogues dialogues;
    private final Commandes commandes;
    private final Timer horloge = new Timer(PERIODE_MS, e -> rafraichir());
    private Etat etat;

    public Cadre(String nom, Etat premier, Consumer<Suite.Evenement> recevoir) {
        this.nom = nom;
        this.recevoir = recevoir;
        etat = premier;
        image = new PanneauImage(premier, recevoir);
        barre = new BarreEtat(premier, image::getPixelSouris);
        image.addPropertyChangeListener(PanneauImage.SOURIS, e -> barre.montrer(etat));
        // un filet autour de l'image, coloré quand elle a le clavier
        JPanel bord = new JPanel(new BorderLayout());
        bord.setBorder(BorderFactory.createEmptyBorder(1, 1, 1, 1));
        bord.add(image);
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addPropertyChangeListener("focusOwner", e -> {
            bord.setBackground(image.isFocusOwner() ? UIManager.getColor("Component.focusColor") : getBackground());
            if (e.getNewValue() instanceof JComponent && !image.isFocusOwner()) {
                JComponent celui = (JComponent) e.getNewValue();
                celui.scrollRectToVisible(new Rectangle(celui.getSize()));
            }
            if (e.getOldValue() == image) {
                recevoir.accept(suite -> suite.tenir(false));
            }
        });
        onglets = new Onglets(this, bord, this::faireLesOnglets, recevoir);
        dialogues = new Dialogues(image, recevoir);
        commandes = new Commandes(getRootPane(), image, onglets::donnerLeClavier, dialogues::direTouches, recevoir);
        add(onglets, BorderLayout.CENTER);
        add(barre, BorderLayout.PAGE_END);
        setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    }

    private void faireLesOnglets() {
        onglets.ajouter("Pixel", 640, new Inspecteur(recevoir));
        onglets.ajouter("Réglages", 300,
                new PanneauReglages(etat.demande.reglages, recevoir, image::requestFocusInWindow));
        onglets.ajouter("Vitesse", 480, new PanneauVitesse(recevoir));
    }

    public Dialogue getDialogues() {
        return dialogues;
    }

    @Override
    protected void processWindowEvent(WindowEvent e) {
        super.processWindowEvent(e);
        if (e.getID() == WindowEvent.WINDOW_CLOSING) {
            recevoir.accept(Suite::quitter);
        }
    }

    /** Se montre à l'écran ; sans scène, en demande une. */
    public void ouvrir() {
        Rectangle ecran = Dialogues.ecran();
        // les bords du cadre sont alors connus ; réduit après coup, il reprend parfois sa taille d'avant
        addNotify();
        setPreferredSize(new Rectangle(getPreferredSize()).intersection(new Rectangle(ecran.getSize())).getSize());
        pack();
        // les panneaux s'ouvrent à droite de l'image
        setLocation(ecran.x + Math.max(0, (ecran.width - getWidth()) / 2 - ecran.width / 5),
                ecran.y + Math.max(0, (ecran.height - getHeight()) / 2));
        if (!etat.aUneScene()) {
            recevoir.accept(suite -> suite.annoncer(Etat.ctrl("O") + " pour ouvrir une scène", false));
            EventQueue.invokeLater(() -> recevoir.accept(Suite::choisirUneScene));
        }
        setVisible(true);
    }

    @Override
    public void montrer(Etat nouveau) {
        boolean autrePolice = nouveau.ecran.police != etat.ecran.police;
        etat = nouveau;
        if (autrePolice) {
            Apparence.donnerAuxTextes(nouveau.ecran.police);
            SwingUtilities.updateComponentTreeUI(this);
        }
        if (nouveau.enCours()) {
            horloge.start();
        } else {
            horloge.stop();
            if (getIconImages().isEmpty() && nouveau.montre.dessin != null) {
                // les icônes montrent la scène du cours ; outils/Makefile les refait
                setIconImages(Stream.of("16", "32", "48", "128").map(cote -> getToolkit().getImage(
                        Cadre.class.getResource("/lancer/fenetre/icone-" + cote + ".png")))
                        .collect(Collectors.toList()));
            }
        }
        String titre = nouveau.getTitre(nom);
        if (!titre.equals(getTitle())) {
            setTitle(titre);
        }
        image.montrer(nouveau);
        onglets.montrer(nouveau);
        commandes.montrer(nouveau);
        barre.montrer(etat);
    }

    private void rafraichir() {
        image.repaint();
        barre.montrer(etat);
    }
}
