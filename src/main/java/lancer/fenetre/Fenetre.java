package lancer.fenetre;

import java.awt.AWTError;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Image;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import lancer.Lancer;
import lancer.SceneFautive;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.lecture.Services;
import lancer.sortie.Dessinateur;
import lancer.sortie.ImageMemoire;

/**
 * La fenêtre : elle montre l'image pendant que {@link Tracage} la dessine. Le fil des événements ne calcule pas, ne lit
 * pas, n'écrit pas et n'attend pas ; une horloge lui fait regarder trente fois par seconde où en est le dessin.
 */
public final class Fenetre {

    /** Temps entre deux regards sur le dessin en cours, en millisecondes. */
    private static final int PERIODE_MS = 33;

    /** Temps laissé à un brouillon avant de montrer ses morceaux, en nanosecondes. */
    private static final long PATIENCE_NS = 300_000_000;

    private final Dessinateur dessinateur;
    private final Dimension taille;
    private final String programme;
    private final String reglages;
    private final Runnable fin;
    private final ExecutorService dessins;
    private final Surveillance surveillance = new Surveillance(() -> EventQueue.invokeLater(this::relire));
    private final PanneauImage panneau;
    private final Bandeau bandeau;
    private final BarreEtat barre = new BarreEtat(this::arreterOuRecharger);
    private final JFrame cadre = new JFrame();
    private final Enregistrement enregistrement;
    private JMenuItem relire;
    private JMenuItem arreter;
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());

    /** Le fichier de la scène montrée : celui du titre, de F5 et de la surveillance ; {@code null} avant le premier. */
    private String fichier;
    /** Celui de la dernière scène lue sans faute, même si son dessin a été abandonné avant de se voir. */
    private String lu;
    private Tracage courant;
    private Tracage adopte;
    /** Les sections que la scène montrée a de laissées de côté, pour le résumé. */
    private String ignorees = "";
    /** Faux seulement quand {@link #finir} est passé : le dessin peut être fini un instant avant qu'on le sache ici. */
    private boolean enCours;
    private ImageMemoire complete;
    private String cout;
    private boolean fermee;

    private Fenetre(Dessinateur dessinateur, Options options, List<String> variantes, ExecutorService dessins,
            Runnable fin) {
        this.dessinateur = dessinateur;
        taille = new Dimension(options.largeur, options.hauteur);
        programme = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        String reflets = options.reflets + (options.reflets > 1 ? " réflexions" : " réflexion");
        reglages = variantes.isEmpty() ? reflets : reflets + ", " + String.join(", ", variantes);
        this.dessins = dessins;
        this.fin = fin;
        panneau = new PanneauImage(taille);
        bandeau = panneau.getBandeau();
        enregistrement = new Enregistrement(cadre, bandeau);
    }

    /**
     * Ouvre la fenêtre sur la scène demandée, et revient ; fermer la fenêtre termine le programme, avec le statut 0.
     *
     * @param erreur où dire ce que cette première scène a de laissé de côté
     * @throws SceneFautive si la scène ne peut être utilisée ; rien ne s'est ouvert
     * @throws Echec s'il n'y a pas d'écran
     */
    public static void ouvrir(Dessinateur dessinateur, Options options, PrintStream erreur) {
        ouvrir(dessinateur, options, erreur, () -> System.exit(CodeSortie.FAIT));
    }

    /** De même, et fermer la fenêtre appelle {@code fin}, dans un autre fil. */
    public static Fenetre ouvrir(Dessinateur dessinateur, Options options, PrintStream erreur, Runnable fin) {
        Dimension taille = new Dimension(options.largeur, options.hauteur);
        Tracage premier = options.scene == null ? null : new Tracage(dessinateur, options.scene, taille);
        if (premier != null) {
            premier.lire();
            Pannes.avertir(premier.getAvertissements(), erreur);
        }
        exigerEcran();
        // un seul fil, donc une image à la fois : la suivante attend là que celle qu'on abandonne ait fini d'écrire
        ExecutorService dessins = Executors.newSingleThreadExecutor(tache -> {
            Thread fil = new Thread(tache, "lancer-dessin");
            fil.setDaemon(true);
            return fil;
        });
        if (premier != null) {
            // sans attendre la fenêtre, plus longue à ouvrir que le brouillon à dessiner
            dessins.execute(premier);
        }
        List<String> variantes = Services.nomsDesVariantes();
        Fenetre[] ouverte = new Fenetre[1];
        try {
            EventQueue.invokeAndWait(() -> {
                Dialogues.preparer();
                ouverte[0] = new Fenetre(dessinateur, options, variantes, dessins, fin);
                ouverte[0].commencer(premier);
            });
        } catch (InvocationTargetException e) {
            throw new Echec(CodeSortie.PANNE, Pannes.message(e.getCause()));
        } catch (InterruptedException e) {
            throw new Echec(CodeSortie.PANNE, "interrompu");
        }
        return ouverte[0];
    }

    private static void exigerEcran() {
        boolean present;
        try {
            present = !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | LinkageError e) {
            // un DISPLAY sans serveur derrière, ou un Java sans ses bibliothèques d'écran
            present = false;
        }
        if (!present) {
            throw new Echec(CodeSortie.PANNE,
                    "pas d'écran pour ouvrir une fenêtre ; attendu : un écran, ou --image FICHIER.png");
        }
    }

    private JMenuBar menus() {
        // Ctrl, ou Commande sur un Mac ; la forme en Ex est de Java 10
        int ctrl = Toolkit.getDefaultToolkit().getMenuShortcutKeyMask();
        JMenuBar menus = new JMenuBar();
        JMenu menu = menu(menus, "Fichier");
        article(menu, "Ouvrir une scène…", KeyStroke.getKeyStroke(KeyEvent.VK_O, ctrl), this::choisirScene);
        article(menu, "Enregistrer l'image…", KeyStroke.getKeyStroke(KeyEvent.VK_S, ctrl), this::enregistrer);
        menu.addSeparator();
        article(menu, "Quitter", KeyStroke.getKeyStroke(KeyEvent.VK_Q, ctrl), this::fermer);
        menu = menu(menus, "Dessin");
        relire = article(menu, "Relire la scène et redessiner", KeyStroke.getKeyStroke(KeyEvent.VK_F5, 0),
                this::recharger);
        // la touche est liée plus bas : Java l'afficherait « Escape »
        arreter = article(menu, "Arrêter (Échap)", null, this::arreter);
        menu = menu(menus, "Aide");
        article(menu, "Touches", KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0), () -> Dialogues.montrerTouches(cadre));
        return menus;
    }

    private static JMenu menu(JMenuBar menus, String nom) {
        JMenu menu = menus.add(new JMenu(nom));
        menu.setMnemonic(nom.charAt(0));
        return menu;
    }

    private static JMenuItem article(JMenu menu, String nom, KeyStroke touche, Runnable action) {
        JMenuItem article = menu.add(new JMenuItem(nom, nom.charAt(0)));
        article.setAccelerator(touche);
        article.addActionListener(e -> action.run());
        return article;
    }

    /** @param premier le dessin qu'il y a déjà à montrer, ou {@code null} */
    private void commencer(Tracage premier) {
        assembler();
        ecouter();
        titrer();
        dessins.execute(() -> {
            List<Image> icones = Icone.dessiner();
            EventQueue.invokeLater(() -> cadre.setIconImages(icones));
        });
        if (premier == null) {
            relire.setEnabled(false);
            arreter.setEnabled(false);
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
        surveillance.commencer();
        cadre.getRootPane().setTransferHandler(new DepotFichier(this::ouvrirScene, bandeau::avis));
        cadre.getRootPane().registerKeyboardAction(e -> arreter(), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
                JComponent.WHEN_IN_FOCUSED_WINDOW);
        cadre.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                fermer();
            }
        });
        panneau.suivreSouris(this::montrerPixel);
        panneau.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                resumer();
            }
        });
    }

    /** Le cadre, qui contient tout ce qui se voit. */
    public JFrame getCadre() {
        return cadre;
    }

    /** L'image montrée si elle est achevée ; {@code null} tant qu'un dessin est en cours, ou s'il a été arrêté. */
    public ImageMemoire getImageComplete() {
        return !enCours && complete == panneau.getImage() ? complete : null;
    }

    /** Vrai tant qu'un dessin est en cours, lecture et préparation comprises. */
    public boolean enCours() {
        return enCours;
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
        if (!enCours || courant.getFichier() == null || courant.getFichier().equals(fichier)) {
            dessiner(fichier);
        }
    }

    private void enregistrer() {
        ImageMemoire image = getImageComplete();
        if (image == null) {
            bandeau.avis(enCours ? "L'image se dessine encore : elle pourra être enregistrée une fois achevée."
                    : "Pas d'image achevée à enregistrer ; F5 pour la dessiner.");
        } else {
            enregistrement.commencer(image, fichier);
        }
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
        if (fermee) {
            return;
        }
        if (courant != null) {
            courant.arreter();
        }
        Tracage tracage = new Tracage(dessinateur, aLire, taille);
        dessins.execute(tracage);
        suivre(tracage);
    }

    private void suivre(Tracage tracage) {
        courant = tracage;
        enCours = true;
        horloge.start();
        resumer();
        observer();
    }

    /** Montre où en est le dessin en cours. */
    private void observer() {
        boolean fini = courant.isFini();
        lu = courant.getAvertissements() != null ? courant.getFichier() : lu;
        // l'image d'abord : vue avec le lancer d'après, elle a au moins son brouillon
        ImageMemoire image = dessinateur.getImage();
        Lancer lancer = courant.getLancer();
        if (lancer != null) {
            panneau.montrer(image, lancer.isBrouillonFait(), courant.getDureeNs() > PATIENCE_NS);
        }
        boolean montree = lancer != null && (image == panneau.getImage() || image == panneau.getNaissante());
        if (montree && courant.getFichier() != null && courant != adopte) {
            adopter(courant);
        }
        barre.avancer(courant);
        relire.setEnabled(fichier != null);
        arreter.setEnabled(!fini);
        montrerPixel();
        if (fini && enCours) {
            finir();
        }
    }

    /** La scène que ce dessin a lue devient celle qui est montrée. */
    private void adopter(Tracage tracage) {
        adopte = tracage;
        fichier = tracage.getFichier();
        surveillance.suivre(fichier, tracage.getVersion());
        titrer();
        bandeau.faute("");
        bandeau.avis(String.join("\n", tracage.getAvertissements()));
        ignorees = "";
        for (String avertissement : tracage.getAvertissements()) {
            ignorees += avertissement.replaceFirst(".*, ligne \\d+, (\\[[^]]*]).*", ", $1 ignorée");
        }
    }

    /** Le dessin est achevé, arrêté, ou n'a pas pu se faire. */
    private void finir() {
        enCours = false;
        horloge.stop();
        Throwable panne = courant.getPanne();
        if (courant.isAcheve()) {
            complete = dessinateur.getImage();
            cout = reglages + ignorees + ", " + BarreEtat.cout(courant.getLancer());
            bandeau.effacerErreur();
            String ecart = courant.getLancer().getTemoignage().ecart;
            if (ecart != null) {
                bandeau.avis(ecart);
            }
        } else if (panne instanceof SceneFautive) {
            refuser(courant, Pannes.message(panne));
        } else if (panne != null) {
            bandeau.erreur(Pannes.message(panne));
        }
        resumer();
        montrerPixel();
    }

    /** La scène montrée reste ; si c'est elle qui est devenue fautive, elle reste aussi surveillée. */
    private void refuser(Tracage fautif, String message) {
        bandeau.faute(message);
        if (fichier == null || fautif.getFichier().equals(fichier)) {
            fichier = fautif.getFichier();
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
        ImageMemoire image = getImageComplete();
        barre.resumer(image, image == null ? 1 : panneau.getReduction(), cout);
    }

    private void montrerPixel() {
        ImageMemoire image = panneau.getNaissante();
        Point pixel = panneau.getPixelSouris(image);
        if (pixel == null) {
            image = panneau.getImage();
            pixel = panneau.getPixelSouris(image);
        }
        barre.montrerPixel(pixel, image, image != complete);
    }

    private void titrer() {
        cadre.setTitle(fichier == null ? programme : programme + " — " + new File(fichier).getName());
    }
}
