package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Image;
import java.awt.KeyEventPostProcessor;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.util.List;
import java.util.concurrent.ExecutorService;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import lancer.commande.Options;
import lancer.dessin.Dessinateur;
import lancer.image.ImageMemoire;

/**
 * La fenêtre : son cadre, ses menus, ses touches, et ce qui s'y lit du dessin que mène {@link Atelier}. Le fil des
 * événements ne calcule pas, ne lit pas, n'écrit pas et n'attend pas ; une horloge lui fait regarder trente fois par
 * seconde où en est le dessin.
 */
public final class Fenetre {

    /** Temps entre deux regards sur le dessin en cours, en millisecondes. */
    private static final int PERIODE_MS = 33;

    /** Temps sans changement de taille avant de redessiner à la nouvelle, en millisecondes. */
    private static final int REPOS_MS = 200;

    final JFrame cadre = new JFrame();
    final Atelier atelier;
    private final String programme;
    private final Runnable fin;
    private final PanneauImage panneau;
    private final BarreEtat barre;
    private final MenuAffichage affichage;
    private final Enregistrement enregistrement;
    /** L'inspecteur, dès qu'on l'a demandé ; {@code null} avant. */
    private Inspecteur inspecteur;
    private final Timer retaille = new Timer(REPOS_MS, e -> ajuster());
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());
    private final KeyEventPostProcessor renvoi = this::renvoyer;
    private final MenuScenes scenes;
    private Touches touches;

    Fenetre(Dessinateur dessinateur, Options options, List<String> variantes, ExecutorService dessins,
            Runnable fin) {
        programme = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        this.fin = fin;
        Dimension taille = new Dimension(options.largeur, options.hauteur);
        panneau = new PanneauImage(taille);
        barre = new BarreEtat(this::arreterOuRecharger, panneau.getPreferredSize().width, variantes.size());
        affichage = new MenuAffichage(cadre, panneau, barre, taille, this::ajuster);
        atelier = new Atelier(dessinateur, dessins, options.fils, panneau, affichage::getTaille);
        atelier.prevenir(this::suivre);
        enregistrement = new Enregistrement(atelier, panneau.bandeau);
        scenes = new MenuScenes(atelier);
        cadre.setJMenuBar(menus(variantes));
    }

    private JMenuBar menus(List<String> variantes) {
        JMenuBar menus = new JMenuBar();
        JMenu menu = menus.add(Menus.menu("Fichier"));
        Menus.article(menu, "Ouvrir une scène…", Menus.ctrl(KeyEvent.VK_O), this::choisirScene);
        Menus.siScene(atelier, Menus.article(menu, "Enregistrer l'image…", Menus.ctrl(KeyEvent.VK_S),
                enregistrement::enregistrer));
        Menus.siScene(atelier, Menus.article(menu, "Copier l'image", Menus.ctrl(KeyEvent.VK_C),
                enregistrement::copier));
        menu.add(panneau.bandeau.copie);
        menu.addSeparator();
        Menus.article(menu, "Quitter", Menus.ctrl(KeyEvent.VK_Q), this::fermer);
        menus.add(affichage.menu);
        Menus.siScene(atelier, Menus.article(affichage.menu, "Rayons d'un pixel (Entrée)", null, this::inspecter));
        menus.add(new MenuDessin(cadre, atelier, variantes).menu);
        menus.add(scenes.menu);
        menu = menus.add(Menus.menu("Aide"));
        // A est à Affichage
        menu.setMnemonic(KeyEvent.VK_I);
        Menus.article(menu, "Touches", Menus.touche(KeyEvent.VK_F1), this::montrerTouches);
        return menus;
    }

    /** @param premier le dessin qu'il y a déjà à montrer, ou {@code null} */
    void commencer(Tracage premier) {
        assembler();
        ecouter();
        titrer();
        if (premier == null) {
            scenes.montrer(null);
            panneau.setInvite("Ctrl+O pour ouvrir une scène, ou déposer ici un fichier .ini");
            EventQueue.invokeLater(this::choisirScene);
        } else {
            atelier.commencer(premier);
        }
        cadre.setVisible(true);
    }

    private void assembler() {
        cadre.add(panneau, BorderLayout.CENTER);
        cadre.add(barre, BorderLayout.PAGE_END);
        cadre.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        cadre.pack();
        Rectangle ecran = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        cadre.setSize(Math.min(cadre.getWidth(), ecran.width), Math.min(cadre.getHeight(), ecran.height));
        cadre.setLocationRelativeTo(null);
    }

    /** À quoi la fenêtre répond, en plus de ses menus. */
    private void ecouter() {
        cadre.getRootPane().setTransferHandler(new DepotFichier(atelier::ouvrir, panneau.bandeau::avis));
        Menus.lier(cadre, Menus.touche(KeyEvent.VK_ESCAPE), this::echapper);
        Menus.lier(cadre, Menus.touche(KeyEvent.VK_ENTER), this::inspecter);
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
        Menus.lier(cadre, Menus.touche(KeyEvent.VK_SPACE), () -> tenir(true));
        Menus.lier(cadre, KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, 0, true), () -> tenir(false));
        retaille.setRepeats(false);
        panneau.suivreSouris(this::decrire, this::inspecter);
        panneau.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                decrire();
                retaille.restart();
            }
        });
        cadre.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentMoved(ComponentEvent e) {
                panneau.perdreSouris();
            }
        });
    }

    private void montrerTouches() {
        touches = touches == null ? new Touches(cadre) : touches;
        Menus.aCote(touches);
    }

    private void choisirScene() {
        File choisi = Dialogues.choisirScene(cadre, atelier.getFichier());
        if (choisi != null) {
            atelier.ouvrir(choisi);
        }
    }

    private void arreterOuRecharger() {
        if (atelier.enCours()) {
            atelier.arreter();
        } else if (atelier.getFichier() == null) {
            choisirScene();
        } else {
            atelier.relire();
        }
    }

    /** Mène l'inspecteur au pixel qui est sous la souris, ou au milieu. */
    private void inspecter() {
        Point pixel = panneau.getPixelVise();
        if (pixel != null) {
            inspecter(pixel);
        }
    }

    private void inspecter(Point pixel) {
        inspecteur = inspecteur == null ? new Inspecteur(cadre, atelier, panneau) : inspecteur;
        inspecteur.montrer(pixel);
    }

    /** Montre l'image d'avant, ou de nouveau celle de maintenant. */
    private void tenir(boolean tenue) {
        panneau.tenir(tenue ? atelier.getAvant() : null);
        decrire();
    }

    /** Arrête le dessin en cours ; sinon ferme la fenêtre d'à côté, celle qui a le clavier ou l'inspecteur. */
    private void echapper() {
        if (atelier.enCours()) {
            atelier.arreter();
        } else if (aCote() != null) {
            aCote().setVisible(false);
        } else if (inspecteur != null && inspecteur.isVisible()) {
            inspecteur.setVisible(false);
        } else {
            affichage.quitterLePleinEcran();
        }
    }

    /** La fenêtre d'à côté qui a le clavier ; {@code null} s'il est à une autre. */
    private Window aCote() {
        Window devant = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusedWindow();
        boolean aCote = devant instanceof JDialog && devant.getOwner() == cadre && !((JDialog) devant).isModal();
        return aCote ? devant : null;
    }

    /** Une touche dont la fenêtre d'à côté n'a rien fait est pour le cadre, mais n'y ouvre pas un menu. */
    private boolean renvoyer(KeyEvent e) {
        if (!e.isConsumed() && !e.isAltDown() && e.getKeyCode() != KeyEvent.VK_F10 && aCote() != null) {
            SwingUtilities.processKeyBindings(new KeyEvent(cadre.getRootPane(), e.getID(), e.getWhen(),
                    e.getModifiersEx(), e.getKeyCode(), e.getKeyChar(), e.getKeyLocation()));
        }
        return false;
    }

    /** Termine : plus aucun dessin, plus de fenêtre, et les images en train de s'écrire le seront jusqu'au bout. */
    private void fermer() {
        if (cadre.isDisplayable()) {
            abandonner();
            enregistrement.terminer(fin);
        }
    }

    /** Ferme la fenêtre, sans finir le programme : sa scène est refusée. */
    void abandonner() {
        if (cadre.isDisplayable()) {
            horloge.stop();
            atelier.terminer();
            if (inspecteur != null) {
                inspecteur.terminer();
            }
            KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventPostProcessor(renvoi);
            cadre.dispose();
        }
    }

    private void ajuster() {
        atelier.ajuster();
    }

    /** Un dessin commence ou finit, ou une scène est lue. */
    private void suivre() {
        if (atelier.enCours()) {
            horloge.start();
        } else {
            horloge.stop();
            donnerIcones();
        }
        titrer();
        avancer();
        decrire();
    }

    /** Charge les icônes, que la première image n'a pas à attendre. */
    private void donnerIcones() {
        if (cadre.getIconImages().isEmpty()) {
            new Thread(() -> {
                List<Image> icones = Icone.lire();
                EventQueue.invokeLater(() -> cadre.setIconImages(icones));
            }, "lancer-icone").start();
        }
    }

    /** Dit où en est le dessin : au bas de la fenêtre, et en plein écran sur l'image. */
    private void avancer() {
        barre.avancer(atelier.getCourant());
        if (affichage.estPlein()) {
            panneau.dire(cadre.getTitle() + " — " + atelier.getCourant().getEtat(), atelier.enCours());
        }
    }

    private void observer() {
        atelier.observer();
        avancer();
        montrerPixel();
    }

    /** Dit ce qu'a coûté l'image montrée, si elle est achevée, et la couleur du pixel sous la souris. */
    private void decrire() {
        ImageMemoire image = panneau.getTenue() != null ? panneau.getTenue()
                : atelier.enCours() ? null : atelier.getImageComplete();
        panneau.getAccessibleContext().setAccessibleDescription(
                barre.resumer(image, image == null ? 1 : panneau.getReduction(image), atelier.getCout(image)));
        montrerPixel();
    }

    private void montrerPixel() {
        ImageMemoire image = panneau.getImageSouris();
        barre.montrerPixel(panneau.getPixelSouris(image), image, atelier.getCout(image) == null);
    }

    private void titrer() {
        String fichier = atelier.getFichier();
        cadre.setTitle(fichier == null ? programme : programme + " — " + new File(fichier).getName());
    }
}
