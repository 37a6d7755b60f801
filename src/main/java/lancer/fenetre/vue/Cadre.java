package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.File;
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
import lancer.image.ImageMemoire;

/** Le cadre : l'image et les onglets, le titre, la ligne du bas. Une horloge y montre où en est le dessin en cours. */
@SuppressWarnings("serial")
public final class Cadre extends JFrame implements Vue, Dialogue {

    private static final int PERIODE_MS = 33;

    /** Le nom du programme et de ses variantes. */
    private final String nom;
    private final Consumer<Suite.Evenement> recevoir;
    private final PanneauImage image;
    private final BarreEtat barre;
    private final Onglets onglets;
    private final Commandes commandes;
    private final Timer horloge = new Timer(PERIODE_MS, e -> rafraichir());
    private Etat etat;
    /** Le dossier que propose le prochain dialogue d'une image. */
    private File dossier = new File("").getAbsoluteFile();

    public Cadre(String nom, Etat premier, Consumer<Suite.Evenement> recevoir) {
        this.nom = nom;
        this.recevoir = recevoir;
        etat = premier;
        image = new PanneauImage(premier, recevoir, this::montrerLaBarre);
        barre = new BarreEtat(premier, image::getPixelSouris);
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
        });
        onglets = new Onglets(this, bord, this::faireLesOnglets, recevoir);
        commandes = new Commandes(this, image, this::choisirScene, onglets::donnerLeClavier, recevoir);
        add(onglets, BorderLayout.CENTER);
        add(barre, BorderLayout.PAGE_END);
        setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                recevoir.accept(Suite::quitter);
            }
        });
    }

    private void faireLesOnglets() {
        onglets.ajouter("Pixel", 640, new Inspecteur(recevoir));
        onglets.ajouter("Réglages", 300,
                new PanneauReglages(etat.demande.reglages, recevoir, image::requestFocusInWindow));
        onglets.ajouter("Vitesse", 480, new PanneauVitesse(recevoir));
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
            EventQueue.invokeLater(this::choisirScene);
        }
        setVisible(true);
    }

    @Override
    public void montrer(Etat nouveau) {
        Etat avant = etat;
        etat = nouveau;
        if (nouveau.ecran.police != avant.ecran.police) {
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
        rafraichir();
    }

    /** Montre l'image, et où en est le dessin. */
    private void rafraichir() {
        image.repaint();
        montrerLaBarre();
    }

    private void montrerLaBarre() {
        barre.montrer(etat);
    }

    private void choisirScene() {
        File choisi = Dialogues.choisirScene(image, etat.getFichier());
        if (choisi != null) {
            recevoir.accept(suite -> suite.ouvrir(choisi.getPath()));
        }
    }

    @Override
    public void demanderDEcrire(String scene) {
        recevoir.accept(Dialogues.demanderDEcrire(image, scene));
    }

    @Override
    public void proposerEcrireSous(String pourquoi, String fichier) {
        File cible = pourquoi == null || Dialogues.proposer(image, pourquoi)
                ? Dialogues.choisirOuEcrire(image, new File(fichier).getAbsoluteFile(), "Écrire la scène sous…", "ini")
                : null;
        recevoir.accept(cible == null ? Suite::rester : suite -> suite.ecrireSous(cible.getPath()));
    }

    @Override
    public void demanderOuEnregistrer(ImageMemoire celle, String scene) {
        String png = new File(scene).getName().replaceFirst("\\.[^.]*$", "") + ".png";
        File cible = Dialogues.choisirOuEcrire(image, new File(dossier, png), "Enregistrer l'image", "png");
        if (cible != null) {
            dossier = cible.getParentFile();
            recevoir.accept(suite -> suite.enregistrerSous(celle, cible, scene));
        }
    }

    @Override
    public void copier(String texte) {
        getToolkit().getSystemClipboard().setContents(new StringSelection(texte), null);
    }

    @Override
    public void copier(ImageMemoire celle) {
        // l'image partage le tableau des codes, qui ne change plus : copier une grande image serait long
        BufferedImage copie = PanneauImage.deJava(celle, celle.codes, false);
        getToolkit().getSystemClipboard().setContents(new Transferable() {
            @Override
            public DataFlavor[] getTransferDataFlavors() {
                return new DataFlavor[] {DataFlavor.imageFlavor};
            }

            @Override
            public boolean isDataFlavorSupported(DataFlavor sorte) {
                return sorte.equals(DataFlavor.imageFlavor);
            }

            @Override
            public Object getTransferData(DataFlavor sorte) {
                return copie;
            }
        }, null);
    }

    @Override
    public void fermer() {
        horloge.stop();
        dispose();
    }
}
