package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsDevice;
import java.awt.Image;
import java.awt.KeyEventPostProcessor;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.ButtonGroup;
import javax.swing.ImageIcon;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;
import javax.swing.Timer;
import javax.swing.TransferHandler;
import javax.swing.WindowConstants;
import lancer.commande.Options;
import lancer.dessin.Dessin;
import lancer.fenetre.Bandeau.Sujet;
import lancer.image.ImageMemoire;

/**
 * La fenêtre : cadre, taille, touches, menus, et affichage du dessin que dirige {@link Controleur}. Le fil des
 * événements ne fait ni calcul, ni lecture, ni écriture, ni attente : une horloge lui fait lire l'état du dessin.
 */
@SuppressWarnings("serial")
public final class Fenetre {

    /** Temps entre deux lectures de l'état du dessin, et temps sans changement de taille avant de redessiner. */
    private static final int PERIODE_MS = 33;
    private static final int REPOS_MS = 200;

    final JFrame cadre = new Cadre();
    final Controleur controleur;
    private final String programme;
    /** La taille de l'image demandée par la ligne de commande. */
    private final Dimension demandee;
    private final Runnable fin;
    private final PanneauImage panneau;
    private final BarreEtat barre;
    private final Enregistrement enregistrement;
    private final Timer retaille;
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());
    private final KeyEventPostProcessor renvoi = this::renvoyer;
    /** Action de chaque caractère, quelle que soit la touche qui le donne. */
    private final Map<Character, Runnable> caracteres = new HashMap<>();
    private JMenuItem remplir;
    private JCheckBoxMenuItem plein;
    /** Position du cadre avant le plein écran. */
    private Rectangle place;
    private final Onglets onglets;
    private final Prise prise;
    private JDialog touches;

    Fenetre(Options options, Dessin premier, Consumer<Dessin> dessinateur, List<String> variantes,
            ExecutorService dessins, Runnable fin) {
        programme = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        this.fin = fin;
        demandee = new Dimension(options.largeur, options.hauteur);
        panneau = new PanneauImage(demandee, this::decrire, this::inspecter);
        barre = new BarreEtat();
        controleur = new Controleur(premier, dessinateur, dessins, options.fils, panneau, this::getTaille);
        controleur.prevenir(this::suivre);
        retaille = new Timer(REPOS_MS, e -> controleur.ajuster());
        enregistrement = new Enregistrement(controleur, panneau.bandeau);
        prise = new Prise(controleur, panneau);
        Map<String, Supplier<JComponent>> contenus = new LinkedHashMap<>();
        contenus.put("Pixel", () -> new Inspecteur(controleur, panneau, caracteres));
        contenus.put("Réglages", () -> new PanneauReglages(controleur));
        contenus.put("Vitesse", () -> new PanneauVitesse(controleur));
        onglets = new Onglets(cadre, panneau, contenus);
        JMenuBar menus = new JMenuBar();
        menus.add(menuFichier());
        menus.add(menuAffichage());
        MenuDessin dessin = new MenuDessin(controleur, variantes);
        menus.add(dessin.menu);
        caracteres.put('+', () -> dessin.changer(true));
        caracteres.put('-', () -> dessin.changer(false));
        menus.add(new MenuScenes(controleur).menu);
        JMenu aide = menus.add(Menus.menu("Aide"));
        // A est la lettre d'Affichage
        aide.setMnemonic(KeyEvent.VK_I);
        Menus.article(aide, "Touches", Menus.touche(KeyEvent.VK_F1), () -> {
            touches = touches == null ? Dialogues.touches(cadre) : touches;
            touches.setVisible(true);
        });
        cadre.setJMenuBar(menus);
    }

    private JMenu menuFichier() {
        JMenu menu = Menus.menu("Fichier");
        Menus.article(menu, "Ouvrir une scène…", Menus.ctrl(KeyEvent.VK_O), this::choisirScene);
        Menus.siScene(controleur, menu, "Enregistrer l'image…", Menus.ctrl(KeyEvent.VK_S), enregistrement::enregistrer);
        Menus.siScene(controleur, menu, "Copier l'image", Menus.ctrl(KeyEvent.VK_C), enregistrement::copier);
        menu.add(panneau.bandeau.copie);
        menu.addSeparator();
        Menus.article(menu, "Quitter", Menus.ctrl(KeyEvent.VK_Q), this::fermer);
        return menu;
    }

    private JMenu menuAffichage() {
        JMenu menu = Menus.menu("Affichage");
        ButtonGroup tailles = new ButtonGroup();
        JMenuItem demander = Menus.choix(menu, tailles, "Taille demandée, " + demandee.width + " × " + demandee.height,
                Menus.ctrl(KeyEvent.VK_1), controleur::ajuster);
        demander.setSelected(true);
        remplir = Menus.choix(menu, tailles, "Remplir la fenêtre", Menus.ctrl(KeyEvent.VK_0), controleur::ajuster);
        plein = new JCheckBoxMenuItem("Plein écran");
        Menus.article(menu, plein, Menus.touche(KeyEvent.VK_F11), this::basculer);
        menu.addSeparator();
        Menus.article(menu, "Loupe : plus près", Menus.ctrl(KeyEvent.VK_UP), () -> panneau.approcher(true));
        Menus.article(menu, "Loupe : plus loin", Menus.ctrl(KeyEvent.VK_DOWN), () -> panneau.approcher(false));
        menu.addSeparator();
        menu.add(Menus.siScene(controleur, menuVues()));
        Menus.siScene(controleur, menu, "Rayons d'un pixel (Entrée)", null, this::inspecter);
        Menus.siScene(controleur, menu, "Réglages", Menus.touche(KeyEvent.VK_F2),
                () -> onglets.montrer(1).transferFocus());
        Menus.siScene(controleur, menu, "Vitesse ou précision", Menus.touche(KeyEvent.VK_F3),
                () -> onglets.montrer(2).transferFocus());
        menu.addSeparator();
        JCheckBoxMenuItem sombre = new JCheckBoxMenuItem("Apparence sombre", Apparence.estSombre());
        Menus.article(menu, sombre, null, () -> Apparence.changer(sombre.isSelected()));
        // Ctrl+1 et Ctrl+0 sur un clavier français, où les chiffres demandent Maj, et au pavé numérique
        Menus.lier(cadre, Menus.ctrl(KeyEvent.VK_AMPERSAND), demander::doClick);
        Menus.lier(cadre, Menus.ctrl(KeyEvent.VK_NUMPAD1), demander::doClick);
        Menus.lier(cadre, Menus.ctrl(KeyEvent.getExtendedKeyCodeForChar('à')), remplir::doClick);
        Menus.lier(cadre, Menus.ctrl(KeyEvent.VK_NUMPAD0), remplir::doClick);
        return menu;
    }

    private JMenu menuVues() {
        JMenu menu = Menus.menu("Vue");
        ButtonGroup vues = new ButtonGroup();
        Menus.choix(menu, vues, "l'image", null, () -> controleur.voir(null)).setSelected(true);
        Options.VUES.forEach(vue -> Menus.choix(menu, vues, vue, null, () -> controleur.voir(vue)));
        return menu;
    }

    /** @param premier le dessin déjà commencé, ou {@code null} */
    void commencer(Tracage premier) {
        cadre.add(onglets, BorderLayout.CENTER);
        cadre.add(barre, BorderLayout.PAGE_END);
        cadre.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        cadre.pack();
        Rectangle ecran = Dialogues.ecran();
        // les panneaux s'ouvrent à droite de l'image
        cadre.setLocation(ecran.x + Math.max(0, (ecran.width - cadre.getWidth() - Onglets.LARGEUR) / 2),
                ecran.y + Math.max(0, (ecran.height - cadre.getHeight()) / 2));
        ecouter();
        titrer();
        if (premier == null) {
            panneau.dire("Ctrl+O pour ouvrir une scène, ou déposer ici un fichier .ini");
            EventQueue.invokeLater(this::choisirScene);
        } else {
            controleur.commencer(premier);
        }
        cadre.setVisible(true);
    }

    private void ecouter() {
        cadre.getRootPane().setTransferHandler(new Depot());
        Menus.lier(cadre, Menus.touche(KeyEvent.VK_ESCAPE), this::echapper);
        Menus.lier(cadre, Menus.touche(KeyEvent.VK_ENTER), this::inspecter);
        Menus.lier(cadre, Menus.touche(KeyEvent.VK_SPACE), () -> tenir(true));
        Menus.lier(cadre, KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, 0, true), () -> tenir(false));
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventPostProcessor(renvoi);
        cadre.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                fermer();
            }

            @Override
            public void windowDeactivated(WindowEvent e) {
                tenir(false);
            }
        });
        retaille.setRepeats(false);
        ComponentAdapter tailleEtPlace = new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                decrire();
                retaille.restart();
            }

            @Override
            public void componentMoved(ComponentEvent e) {
                panneau.perdreSouris();
            }
        };
        panneau.addComponentListener(tailleEtPlace);
        cadre.addComponentListener(tailleEtPlace);
    }

    /** Un cadre qui tient dans l'écran. Le réduire après coup ne suffit pas : il reprend parfois sa taille d'avant. */
    private static final class Cadre extends JFrame {

        @Override
        public Dimension getPreferredSize() {
            return new Rectangle(super.getPreferredSize())
                    .intersection(new Rectangle(Dialogues.ecran().getSize())).getSize();
        }
    }

    private final class Depot extends TransferHandler {

        @Override
        public boolean canImport(TransferSupport depot) {
            return depot.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
        }

        @Override
        public boolean importData(TransferSupport depot) {
            try {
                List<?> fichiers = (List<?>) depot.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
                if (fichiers.size() == 1) {
                    controleur.ouvrir(((File) fichiers.get(0)).getPath());
                } else {
                    panneau.bandeau.dire(Sujet.AVIS, "une scène à la fois : " + fichiers.size() + " fichiers déposés");
                }
                return fichiers.size() == 1;
            } catch (UnsupportedFlavorException | IOException e) {
                return false;
            }
        }
    }

    private Dimension getTaille() {
        return remplir.isSelected() || plein.isSelected() ? panneau.getTailleMax(demandee.width, demandee.height)
                : demandee;
    }

    private void basculer() {
        boolean entre = plein.isSelected();
        GraphicsDevice ecran = cadre.getGraphicsConfiguration().getDevice();
        place = entre ? cadre.getBounds() : place;
        // la barre de titre ne peut être ôtée qu'à un cadre fermé
        cadre.dispose();
        cadre.setUndecorated(entre);
        // des menus cachés ne répondraient plus à leurs touches
        cadre.getJMenuBar().setPreferredSize(entre ? new Dimension() : null);
        barre.setVisible(!entre);
        ecran.setFullScreenWindow(entre ? cadre : null);
        cadre.setBounds(entre ? cadre.getBounds() : place);
        cadre.setVisible(true);
        cadre.requestFocus();
        controleur.ajuster();
    }

    private void choisirScene() {
        File choisi = Dialogues.choisirScene(cadre, controleur.fichier);
        if (choisi != null) {
            controleur.ouvrir(choisi.getPath());
        }
    }

    private void inspecter() {
        Point pixel = panneau.getPixelVise();
        if (pixel != null) {
            ((Inspecteur) onglets.montrer(0)).montrer(pixel);
        }
    }

    private void tenir(boolean tenue) {
        ImageMemoire voulue = tenue ? controleur.avant : null;
        if (voulue != panneau.tenue) {
            panneau.tenue = voulue;
            panneau.dire(tenue ? "avant : " + panneau.legendes.get(voulue) : "");
            decrire();
        }
    }

    private void echapper() {
        if (controleur.enCours) {
            controleur.arreter();
        } else if (prise.estPris()) {
            prise.lacher();
        } else if (touches != null && touches.isVisible()) {
            touches.setVisible(false);
        } else if (onglets.estOuvert()) {
            onglets.fermer();
        } else if (plein.isSelected()) {
            plein.doClick();
        }
    }

    /** Exécute l'action d'un caractère qu'aucun composant n'a utilisé. */
    private boolean renvoyer(KeyEvent e) {
        if (e.getID() == KeyEvent.KEY_PRESSED && !e.isConsumed() && cadre.isFocused()
                && !e.isAltDown() && !e.isControlDown() && !e.isMetaDown()
                && MenuSelectionManager.defaultManager().getSelectedPath().length == 0) {
            caracteres.getOrDefault(Character.toLowerCase(e.getKeyChar()), () -> { }).run();
        }
        return false;
    }

    /** Arrête les dessins, ferme la fenêtre, et laisse finir les écritures en cours. */
    private void fermer() {
        if (cadre.isDisplayable()) {
            abandonner();
            enregistrement.terminer(fin);
        }
    }

    /** Ferme la fenêtre sans finir le programme : la première scène est refusée. */
    void abandonner() {
        horloge.stop();
        controleur.terminer();
        // fermer l'onglet arrête son calcul
        onglets.fermer();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventPostProcessor(renvoi);
        cadre.dispose();
    }

    private void suivre() {
        if (controleur.enCours) {
            horloge.start();
        } else {
            horloge.stop();
            donnerIcones();
        }
        titrer();
        avancer();
        decrire();
    }

    /** Charge les icônes dans un autre fil, pour ne pas retarder la première image. */
    private void donnerIcones() {
        if (cadre.getIconImages().isEmpty()) {
            new Thread(() -> {
                // les icônes montrent la scène du cours ; « make images » les refait
                List<Image> icones = Stream.of("16", "32", "48", "128").map(cote ->
                        new ImageIcon(Fenetre.class.getResource("icone-" + cote + ".png")).getImage())
                        .collect(Collectors.toList());
                EventQueue.invokeLater(() -> cadre.setIconImages(icones));
            }, "lancer-icone").start();
        }
    }

    private void avancer() {
        barre.avancer(controleur.enCours ? controleur.courant : null);
        if (controleur.enCours || controleur.getImageComplete() == null) {
            barre.resumer(controleur.courant.getEtat());
        }
        if (plein.isSelected()) {
            panneau.dire(controleur.enCours ? cadre.getTitle() + " — " + controleur.courant.getEtat() : "");
        }
    }

    private void observer() {
        controleur.observer();
        avancer();
        montrerPixel();
    }

    /** Affiche le coût de l'image montrée, si elle est achevée, et la couleur du pixel sous la souris. */
    private void decrire() {
        ImageMemoire image = panneau.tenue != null ? panneau.tenue
                : controleur.enCours ? null : controleur.getImageComplete();
        String resume = image == null ? "" : BarreEtat.resume(image, panneau.getReduction(image))
                + ", " + panneau.legendes.get(image);
        if (image != null) {
            barre.resumer(resume);
        }
        panneau.getAccessibleContext().setAccessibleDescription(resume);
        montrerPixel();
    }

    private void montrerPixel() {
        ImageMemoire image = panneau.getVisible();
        barre.montrerPixel(image == panneau.apercu ? null : panneau.getPixelSouris(image), image,
                !panneau.legendes.containsKey(image));
    }

    private void titrer() {
        String fichier = controleur.fichier;
        cadre.setTitle(fichier == null ? programme : programme + " — " + new File(fichier).getName());
    }
}
