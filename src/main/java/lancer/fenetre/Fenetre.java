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
import java.util.ArrayList;
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
import lancer.Lancer;
import lancer.SceneFautive;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.dessin.Dessinateur;
import lancer.dessin.ReglagesDessin;
import lancer.sortie.ImageMemoire;

/**
 * La fenêtre : elle montre l'image pendant que {@link Tracage} la dessine. Le fil des événements ne calcule pas, ne lit
 * pas, n'écrit pas et n'attend pas ; une horloge lui fait regarder trente fois par seconde où en est le dessin.
 */
public final class Fenetre implements Atelier {

    /** Temps entre deux regards sur le dessin en cours, en millisecondes. */
    private static final int PERIODE_MS = 33;

    /** Temps sans changement de taille avant de redessiner à la nouvelle, en millisecondes. */
    private static final int REPOS_MS = 200;

    /** Temps laissé à un brouillon avant de montrer ses morceaux, en nanosecondes. */
    private static final long PATIENCE_NS = 300_000_000;

    /** Au-delà de tant de pixels, l'image d'avant ne se garde pas : elle prendrait autant que celle de maintenant. */
    private static final int PIXELS_GARDES = 16_000_000;

    private final Dessinateur dessinateur;
    private final MenuAffichage affichage;
    private final String programme;
    private final int fils;
    private final Runnable fin;
    private final ExecutorService dessins;
    private final Surveillance surveillance = new Surveillance(() -> EventQueue.invokeLater(this::relire));
    private final PanneauImage panneau;
    private final Bandeau bandeau;
    private final BarreEtat barre;
    private final JFrame cadre = new JFrame();
    private final Enregistrement enregistrement;
    private final List<Runnable> prevenus = new ArrayList<>();
    private final MenuDessin menuDessin;
    private Inspecteur inspecteur;
    private final MenuScenes scenes = new MenuScenes(this::ouvrirScene);
    private final Timer retaille = new Timer(REPOS_MS, e -> ajuster());
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());
    private final KeyEventPostProcessor renvoi = this::renvoyer;

    /** Le fichier de la scène montrée : celui du titre, de F5 et de la surveillance ; {@code null} avant le premier. */
    private String fichier;
    /** Celui de la dernière scène lue sans faute, même si son dessin a été abandonné avant de se voir. */
    private String lu;
    private Tracage courant;
    private Tracage adopte;
    private ReglagesDessin reglages;
    /** Les sections que la scène montrée a de laissées de côté, pour le résumé. */
    private String ignorees = "";
    /** Faux seulement quand {@link #finir} est passé : le dessin peut être fini un instant avant qu'on le sache ici. */
    private boolean enCours;
    /** La dernière image achevée, celle d'avant elle, et ce que chacune a coûté. */
    private ImageMemoire complete;
    private String cout;
    private ImageMemoire avant;
    private String coutAvant;
    /** Vrai si d'autres réglages attendent que le brouillon en cours se soit vu. */
    private boolean enAttente;
    private boolean fermee;

    Fenetre(Dessinateur dessinateur, Options options, List<String> variantes, ExecutorService dessins,
            Runnable fin) {
        this.dessinateur = dessinateur;
        programme = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        this.dessins = dessins;
        this.fin = fin;
        fils = options.fils;
        Dimension taille = new Dimension(options.largeur, options.hauteur);
        panneau = new PanneauImage(taille);
        barre = new BarreEtat(this::arreterOuRecharger, panneau.getPreferredSize().width, variantes.size());
        affichage = new MenuAffichage(cadre, panneau, barre, taille, this::ajuster);
        bandeau = panneau.bandeau;
        enregistrement = new Enregistrement(this, bandeau);
        menuDessin = new MenuDessin(this, variantes, this::recharger, this::arreter);
    }

    private JMenuBar menus() {
        JMenuBar menus = new JMenuBar();
        JMenu menu = menus.add(Menus.menu("Fichier"));
        Menus.article(menu, "Ouvrir une scène…", Menus.ctrl(KeyEvent.VK_O), this::choisirScene);
        Menus.siScene(this, Menus.article(menu, "Enregistrer l'image…", Menus.ctrl(KeyEvent.VK_S),
                () -> enregistrement.enregistrer(fichier)));
        Menus.siScene(this, Menus.article(menu, "Copier l'image", Menus.ctrl(KeyEvent.VK_C), enregistrement::copier));
        menu.add(bandeau.copie);
        menu.addSeparator();
        Menus.article(menu, "Quitter", Menus.ctrl(KeyEvent.VK_Q), this::fermer);
        menus.add(affichage.menu);
        Menus.siScene(this, Menus.article(affichage.menu, "Rayons d'un pixel (Entrée)", null, this::inspecter));
        menus.add(menuDessin.menu);
        menus.add(scenes.menu);
        menu = menus.add(Menus.menu("Aide"));
        // A est à Affichage
        menu.setMnemonic(KeyEvent.VK_I);
        Menus.article(menu, "Touches", Menus.touche(KeyEvent.VK_F1), () -> Dialogues.montrerTouches(cadre));
        return menus;
    }

    /** @param premier le dessin qu'il y a déjà à montrer, ou {@code null} */
    void commencer(Tracage premier) {
        assembler();
        ecouter();
        titrer();
        new Thread(() -> {
            List<Image> icones = Icone.lire();
            EventQueue.invokeLater(() -> cadre.setIconImages(icones));
        }, "lancer-icone").start();
        if (premier == null) {
            panneau.setInvite("Ctrl+O pour ouvrir une scène, ou déposer ici un fichier .ini");
            EventQueue.invokeLater(this::choisirScene);
        } else {
            adopter(premier);
            suivre(premier);
        }
        cadre.setVisible(true);
    }

    private void assembler() {
        cadre.setJMenuBar(menus());
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
        cadre.getRootPane().setTransferHandler(new DepotFichier(this::ouvrirScene, bandeau::avis));
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
        for (boolean lachee : new boolean[] {false, true}) {
            Menus.lier(cadre, KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, 0, lachee), () -> tenir(!lachee));
        }
        retaille.setRepeats(false);
        inspecteur = new Inspecteur(this, panneau);
        panneau.suivreSouris(() -> {
            montrerPixel();
            resumer();
        }, inspecteur::montrer);
        panneau.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                montrerPixel();
                resumer();
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

    /** Mène l'inspecteur au pixel qui est sous la souris, ou au milieu. */
    private void inspecter() {
        Point pixel = panneau.getPixelVise();
        if (pixel != null) {
            inspecteur.montrer(pixel);
        }
    }

    @Override
    public JFrame getCadre() {
        return cadre;
    }

    @Override
    public ImageMemoire getImageComplete() {
        return !enCours && complete == panneau.getImage() ? complete : null;
    }

    @Override
    public boolean enCours() {
        return enCours;
    }

    @Override
    public ReglagesDessin getReglages() {
        return reglages;
    }

    @Override
    public Lancer getLancer() {
        return courant == null ? null : courant.getLancer();
    }

    @Override
    public String getCommande() {
        Dimension taille = affichage.getTaille();
        return Pannes.commande("", reglages.getOptions(), fichier, taille.width, taille.height);
    }

    @Override
    public int getFils() {
        return fils;
    }

    @Override
    public void prevenir(Runnable siChange) {
        prevenus.add(siChange);
    }

    @Override
    public void dessiner(ReglagesDessin voulus, boolean suite) {
        reglages = voulus;
        if (suite && enCours && !courant.isBrouillonFait()) {
            enAttente = true;
        } else {
            redessiner(suite);
        }
    }

    private void redessiner(boolean suite) {
        if (!suite) {
            retenir();
        }
        // une scène qui se lit se relit ; celle qui est lue n'est pas toujours celle qui se voit
        boolean autre = enCours && courant.fichier != null && courant != adopte;
        lancer(autre ? courant.fichier : fichier.equals(lu) ? null : fichier);
    }

    /** L'image achevée devient celle d'avant ; une trop grande ne se garde pas. */
    private void retenir() {
        boolean gardee = complete != null && complete.getCodes().length <= PIXELS_GARDES;
        avant = gardee ? complete : null;
        coutAvant = cout;
    }

    /** Redessine, si ce n'est plus à cette taille qu'il faut dessiner. */
    private void ajuster() {
        if (courant != null && fichier != null && !affichage.getTaille().equals(courant.taille)) {
            redessiner(true);
        }
        resumer();
    }

    /** Montre l'image d'avant, ou de nouveau celle de maintenant. */
    private void tenir(boolean tenue) {
        panneau.tenir(tenue ? avant : null);
        resumer();
        montrerPixel();
    }

    private void choisirScene() {
        File choisi = Dialogues.choisirScene(cadre, fichier);
        if (choisi != null) {
            ouvrirScene(choisi);
        }
    }

    private void ouvrirScene(File choisi) {
        panneau.setInvite(null);
        dessiner(choisi.getPath());
    }

    private void arreterOuRecharger() {
        if (enCours) {
            arreter();
        } else {
            recharger();
        }
    }

    private void recharger() {
        if (fichier == null) {
            choisirScene();
        } else {
            dessiner(fichier);
        }
    }

    /** Le fichier de la scène montrée a changé ; une autre scène qui se lit passe avant. */
    private void relire() {
        if (!enCours || courant.fichier == null || courant.fichier.equals(fichier)) {
            dessiner(fichier);
        }
    }

    /** Arrête le dessin en cours ; sinon ferme la fenêtre d'à côté, celle qui a le clavier ou l'inspecteur. */
    private void echapper() {
        Window devant = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusedWindow();
        if (enCours) {
            arreter();
        } else if (estACote(devant)) {
            devant.setVisible(false);
        } else if (inspecteur.isVisible()) {
            inspecteur.setVisible(false);
        } else {
            affichage.quitterLePleinEcran();
        }
    }

    private boolean estACote(Window fenetre) {
        return fenetre instanceof JDialog && fenetre.getOwner() == cadre && !((JDialog) fenetre).isModal();
    }

    /** Une touche dont la fenêtre d'à côté n'a rien fait est pour le cadre, mais n'y ouvre pas un menu. */
    private boolean renvoyer(KeyEvent e) {
        if (!e.isConsumed() && !e.isAltDown() && e.getKeyCode() != KeyEvent.VK_F10
                && estACote(KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusedWindow())) {
            SwingUtilities.processKeyBindings(new KeyEvent(cadre.getRootPane(), e.getID(), e.getWhen(),
                    e.getModifiersEx(), e.getKeyCode(), e.getKeyChar(), e.getKeyLocation()));
        }
        return false;
    }

    private void arreter() {
        if (enCours) {
            courant.arreter();
            observer();
        }
    }

    /** Termine : plus aucun dessin, plus de fenêtre, et les images en train de s'écrire le seront jusqu'au bout. */
    private void fermer() {
        if (fermee) {
            return;
        }
        fermee = true;
        horloge.stop();
        if (courant != null) {
            courant.arreter();
        }
        surveillance.terminer();
        inspecteur.terminer();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventPostProcessor(renvoi);
        dessins.shutdown();
        cadre.dispose();
        enregistrement.terminer(fin);
    }

    /**
     * Recommence le dessin ; l'ancienne image reste jusqu'au brouillon de la nouvelle.
     *
     * @param aLire la scène à lire d'abord, {@code null} pour celle qui l'est déjà
     */
    private void dessiner(String aLire) {
        retenir();
        lancer(aLire);
    }

    private void lancer(String aLire) {
        enAttente = false;
        if (fermee) {
            return;
        }
        if (courant != null) {
            courant.arreter();
        }
        Tracage tracage = new Tracage(dessinateur, aLire, affichage.getTaille(), reglages);
        dessins.execute(tracage);
        suivre(tracage);
    }

    private void suivre(Tracage tracage) {
        courant = tracage;
        enCours = true;
        horloge.start();
        resumer();
        prevenus.forEach(Runnable::run);
        observer();
    }

    /** Montre où en est le dessin en cours. */
    private void observer() {
        boolean fini = courant.isFini();
        lu = courant.getAvertissements() != null ? courant.fichier : lu;
        // l'image d'abord : vue avec le lancer d'après, elle a au moins son brouillon
        ImageMemoire image = dessinateur.getImage();
        Lancer lancer = courant.getLancer();
        if (lancer != null) {
            panneau.montrer(image, lancer.isBrouillonFait(), courant.getDureeNs() > PATIENCE_NS);
        }
        boolean montree = lancer != null && (image == panneau.getImage() || image == panneau.getNaissante());
        if (montree && courant.fichier != null && courant != adopte) {
            adopter(courant);
        }
        barre.avancer(courant);
        montrerPixel();
        if (fini && enCours) {
            finir();
        }
        if (enAttente && (fini || courant.isBrouillonFait())) {
            redessiner(true);
        }
    }

    /** La scène que ce dessin a lue devient celle qui est montrée. */
    private void adopter(Tracage tracage) {
        adopte = tracage;
        reglages = tracage.getReglages() != null ? tracage.getReglages() : dessinateur.getReglages();
        fichier = tracage.fichier;
        surveillance.suivre(fichier, tracage.getVersion());
        titrer();
        scenes.montrer(fichier);
        bandeau.faute("");
        bandeau.avis(String.join("\n", tracage.getAvertissements()));
        ignorees = "";
        for (String avertissement : tracage.getAvertissements()) {
            ignorees += avertissement.replaceFirst(".*, ligne \\d+, (\\[[^]]*]).*", ", $1 ignorée");
        }
        prevenus.forEach(Runnable::run);
    }

    /** Le dessin est achevé, arrêté, ou n'a pas pu se faire. */
    private void finir() {
        enCours = false;
        horloge.stop();
        Throwable panne = courant.getPanne();
        if (courant.isAcheve()) {
            complete = dessinateur.getImage();
            cout = BarreEtat.cout(courant.getLancer()) + ", " + courant.getReglages() + ignorees;
            bandeau.effacerErreur();
            String ecart = courant.getLancer().getEcart();
            if (ecart != null) {
                bandeau.avis(ecart);
            }
        } else if (panne instanceof SceneFautive) {
            if (courant.fichier == null) {
                bandeau.erreur(Pannes.message(panne));
            } else {
                refuser(courant, Pannes.message(panne));
            }
        } else if (panne != null) {
            bandeau.erreur(Pannes.message(panne));
        }
        resumer();
        montrerPixel();
        prevenus.forEach(Runnable::run);
    }

    /** La scène montrée reste ; si c'est elle qui est devenue fautive, elle reste aussi surveillée. */
    private void refuser(Tracage fautif, String message) {
        bandeau.faute(message);
        if (fichier == null || fautif.fichier.equals(fichier)) {
            fichier = fautif.fichier;
            surveillance.suivre(fichier, fautif.getVersion());
            titrer();
        }
        if (fichier.equals(lu) && getImageComplete() == null) {
            // la faute a interrompu un dessin de la scène d'avant : c'est lui, la dernière bonne image
            dessiner(null);
        }
    }

    /** Dit ce qu'a coûté l'image montrée, si elle est achevée. */
    private void resumer() {
        ImageMemoire image = panneau.getTenue() != null ? avant : getImageComplete();
        barre.resumer(image, image == null ? 1 : panneau.getReduction(image), image == avant ? coutAvant : cout);
    }

    private void montrerPixel() {
        boolean tenue = panneau.getTenue() != null;
        ImageMemoire image = tenue ? panneau.getTenue() : panneau.getNaissante();
        Point pixel = panneau.getPixelSouris(image);
        if (pixel == null && !tenue) {
            image = panneau.getImage();
            pixel = panneau.getPixelSouris(image);
        }
        barre.montrerPixel(pixel, image, !tenue && image != complete);
    }

    private void titrer() {
        cadre.setTitle(fichier == null ? programme : programme + " — " + new File(fichier).getName());
    }
}
