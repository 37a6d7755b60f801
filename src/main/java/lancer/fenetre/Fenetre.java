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
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import lancer.Lancer;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.dessin.Dessinateur;
import lancer.dessin.ReglagesDessin;
import lancer.lecture.Services;
import lancer.sortie.BarreProgression;
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
    private final BarreEtat barre = new BarreEtat(this::arreterOuRecharger);
    private final JFrame cadre = new JFrame();
    private final Enregistrement enregistrement;
    private final List<Runnable> prevenus = new ArrayList<>();
    private final MenuDessin menuDessin;
    private Inspecteur inspecteur;
    private final MenuScenes scenes = new MenuScenes(this::ouvrirScene);
    private final Timer retaille = new Timer(REPOS_MS, e -> ajuster());
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());

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

    private Fenetre(Dessinateur dessinateur, Options options, List<String> variantes, ExecutorService dessins,
            Runnable fin) {
        this.dessinateur = dessinateur;
        programme = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        this.dessins = dessins;
        this.fin = fin;
        fils = options.fils;
        Dimension taille = new Dimension(options.largeur, options.hauteur);
        panneau = new PanneauImage(taille);
        affichage = new MenuAffichage(cadre, panneau, barre, taille, this::ajuster);
        bandeau = panneau.getBandeau();
        enregistrement = new Enregistrement(cadre, bandeau);
        menuDessin = new MenuDessin(this, variantes, this::recharger, this::arreter);
    }

    /**
     * Ouvre la fenêtre sur la scène demandée, et revient ; fermer la fenêtre termine le programme, avec le statut 0.
     *
     * @param erreur où dire ce que cette première scène a de laissé de côté
     * @throws SceneFautive si la scène ne peut être utilisée ; rien ne s'est ouvert
     * @throws Echec s'il n'y a pas d'écran
     */
    public static void ouvrir(Dessinateur dessinateur, Options options, PrintStream erreur) {
        ouvrir(dessinateur, options, erreur, () -> System.exit(0));
    }

    /** De même, et fermer la fenêtre appelle {@code fin}, dans un autre fil. */
    public static Fenetre ouvrir(Dessinateur dessinateur, Options options, PrintStream erreur, Runnable fin) {
        Dimension taille = new Dimension(options.largeur, options.hauteur);
        Tracage premier = options.scene == null ? null : new Tracage(dessinateur, options.scene, taille, null);
        if (premier != null) {
            // la fenêtre n'est pas encore là pour le dire
            BarreProgression barre = BarreProgression.commencer(dessinateur::getAvancement, erreur);
            try {
                premier.lire();
            } finally {
                barre.finir();
            }
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
            throw Echec.panne(Pannes.message(e.getCause()));
        } catch (InterruptedException e) {
            throw Echec.panne("interrompu");
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
            throw Echec.panne("pas d'écran pour ouvrir une fenêtre ; attendu : un écran, ou --image FICHIER.png");
        }
    }

    private JMenuBar menus() {
        JMenuBar menus = new JMenuBar();
        JMenu menu = menus.add(Menus.menu("Fichier"));
        Menus.article(menu, "Ouvrir une scène…", Menus.ctrl(KeyEvent.VK_O), this::choisirScene);
        Menus.article(menu, "Enregistrer l'image…", Menus.ctrl(KeyEvent.VK_S), this::enregistrer);
        Menus.article(menu, "Copier l'image", Menus.ctrl(KeyEvent.VK_C), this::copier);
        menu.addSeparator();
        Menus.article(menu, "Quitter", Menus.ctrl(KeyEvent.VK_Q), this::fermer);
        menus.add(affichage.getMenu());
        menus.add(menuDessin.getMenu());
        menus.add(scenes.getMenu());
        menu = menus.add(Menus.menu("Aide"));
        Menus.article(menu, "Touches", Menus.touche(KeyEvent.VK_F1), () -> Dialogues.montrerTouches(cadre));
        return menus;
    }

    /** @param premier le dessin qu'il y a déjà à montrer, ou {@code null} */
    private void commencer(Tracage premier) {
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
        surveillance.commencer();
        cadre.getRootPane().setTransferHandler(new DepotFichier(this::ouvrirScene, bandeau::avis));
        cadre.getRootPane().registerKeyboardAction(e -> echapper(), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
                JComponent.WHEN_IN_FOCUSED_WINDOW);
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
        affichage.lierTouches(cadre.getRootPane());
        menuDessin.lierTouches(cadre.getRootPane());
        for (boolean lachee : new boolean[] {false, true}) {
            cadre.getRootPane().registerKeyboardAction(e -> tenir(!lachee),
                    KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, 0, lachee), JComponent.WHEN_IN_FOCUSED_WINDOW);
        }
        retaille.setRepeats(false);
        panneau.suivreSouris(() -> {
            montrerPixel();
            resumer();
        });
        inspecteur = new Inspecteur(this, panneau);
        panneau.suivreClics(inspecteur::montrer);
        panneau.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                resumer();
                retaille.restart();
            }
        });
    }

    /** Le cadre, qui contient tout ce qui se voit. */
    @Override
    public JFrame getCadre() {
        return cadre;
    }

    /** L'image montrée si elle est achevée ; {@code null} tant qu'un dessin est en cours, ou s'il a été arrêté. */
    @Override
    public ImageMemoire getImageComplete() {
        return !enCours && complete == panneau.getImage() ? complete : null;
    }

    /** Vrai tant qu'un dessin est en cours, lecture et préparation comprises. */
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
        boolean autre = enCours && courant.getFichier() != null && courant != adopte;
        lancer(autre ? courant.getFichier() : fichier.equals(lu) ? null : fichier);
    }

    /** L'image achevée devient celle d'avant ; une trop grande ne se garde pas. */
    private void retenir() {
        boolean gardee = complete != null && complete.getCodes().length <= PIXELS_GARDES;
        avant = gardee ? complete : null;
        coutAvant = cout;
    }

    /** Redessine, si ce n'est plus à cette taille qu'il faut dessiner. */
    private void ajuster() {
        if (courant != null && fichier != null && !affichage.getTaille().equals(courant.getTaille())) {
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
        if (!enCours || courant.getFichier() == null || courant.getFichier().equals(fichier)) {
            dessiner(fichier);
        }
    }

    private void enregistrer() {
        ImageMemoire image = imageOuAvis();
        if (image != null) {
            enregistrement.commencer(image, fichier);
        }
    }

    private void copier() {
        ImageMemoire image = imageOuAvis();
        if (image != null) {
            cadre.getToolkit().getSystemClipboard().setContents(new ImageCopiee(PanneauImage.copie(image)), null);
            bandeau.avis("image copiée, " + image.getLargeur() + " × " + image.getHauteur() + " pixels");
        }
    }

    /** L'image achevée ; à défaut, dit pourquoi il n'y en a pas. */
    private ImageMemoire imageOuAvis() {
        ImageMemoire image = getImageComplete();
        if (image == null) {
            bandeau.avis(enCours ? "L'image se dessine encore : elle servira une fois achevée."
                    : "Pas d'image achevée ; F5 pour la dessiner.");
        }
        return image;
    }

    @Override
    public void echapper() {
        if (enCours) {
            arreter();
        } else if (inspecteur.isVisible()) {
            inspecteur.fermer();
        } else {
            affichage.quitterLePleinEcran();
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
        inspecteur.terminer();
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
        fichier = tracage.getFichier();
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
            if (courant.getFichier() == null) {
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
