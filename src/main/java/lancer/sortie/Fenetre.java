package lancer.sortie;

import java.awt.AWTError;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Rectangle;
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
import javax.swing.KeyStroke;
import javax.swing.Timer;
import lancer.Lancer;
import lancer.Main;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.lecture.Variantes;

/**
 * La fenêtre : elle montre l'image pendant que {@link Tracage} la dessine. Le fil des événements ne calcule pas, ne lit pas,
 * n'écrit pas et n'attend pas ; une horloge lui fait regarder trente fois par seconde où en est le dessin.
 */
public final class Fenetre {

    /** Temps entre deux regards sur le dessin en cours, en millisecondes. */
    private static final int PERIODE_MS = 33;

    /** Temps qu'on laisse à un brouillon avant de montrer ses morceaux, ou de le refaire à une autre taille, en nanosecondes. */
    private static final long PATIENCE_NS = 300_000_000;

    private final Main main;
    private final PrintStream sortie;
    private final List<String> variantes;
    private final Runnable fin;
    private final JFrame cadre = new JFrame();
    private final PanneauImage panneau = new PanneauImage();
    private final BarreEtat barre = new BarreEtat(this);
    private final Surveillance surveillance;
    private final Enregistrement enregistrement;
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());
    /** Un seul fil, donc un dessin à la fois : le suivant attend là que l'annulé ait vraiment fini d'écrire. */
    private final ExecutorService dessins;

    private String fichier;
    private String fichierMontre;
    private boolean fichierFautif;
    private Tracage courant;
    /** Faux seulement quand {@link #finir} est passé : le dessin peut être fini un instant avant qu'on le sache ici. */
    private boolean enCours;
    private Dimension taille = new Dimension();
    private ImageMemoire complete;
    private boolean fermee;

    private Fenetre(Main main, PrintStream sortie, Surveillance surveillance, ExecutorService dessins, Tracage premier,
            List<String> variantes, Runnable fin) {
        this.main = main;
        this.sortie = sortie;
        this.variantes = variantes;
        this.surveillance = surveillance;
        this.dessins = dessins;
        this.fin = fin;
        this.fichier = main.getOptions().scene;
        this.fichierMontre = fichier;
        this.enregistrement = new Enregistrement(this);
        cadre.setJMenuBar(new MenuFenetre(this));
        cadre.getRootPane().registerKeyboardAction(e -> arreter(), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
                JComponent.WHEN_IN_FOCUSED_WINDOW);
        cadre.add(panneau, BorderLayout.CENTER);
        cadre.add(barre, BorderLayout.PAGE_END);
        cadre.getRootPane().setTransferHandler(new DepotFichier(this));
        cadre.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        cadre.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                fermer();
            }
        });
        panneau.setPreferredSize(new Dimension(main.getOptions().largeur, main.getOptions().hauteur));
        panneau.suivreSouris(this::montrerPixel);
        panneau.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                suivreTaille();
            }
        });
        // un écran d'une autre densité : les mêmes points, plus ou moins de pixels
        panneau.addPropertyChangeListener("graphicsConfiguration", e -> suivreTaille());
        cadre.pack();
        Rectangle ecran = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        cadre.setSize(Math.min(cadre.getWidth(), ecran.width), Math.min(cadre.getHeight(), ecran.height));
        cadre.setLocationRelativeTo(null);
        cadre.validate();
        titrer();
        surveillance.commencer(this::fichierChange);
        if (fichier == null) {
            panneau.setInvite("Ctrl+O pour ouvrir une scène, ou déposer ici un fichier .ini");
            cadre.setVisible(true);
            EventQueue.invokeLater(this::choisirScene);
        } else {
            avertir();
            suivre(premier);
            cadre.setVisible(true);
        }
    }

    /**
     * Ouvre la fenêtre sur la scène demandée, et revient ; fermer la fenêtre termine le programme, avec le statut 0.
     *
     * @throws SceneFautive si la scène ne peut être utilisée ; rien ne s'est ouvert
     * @throws Echec s'il n'y a pas d'écran
     */
    public static Fenetre ouvrir(Main main, PrintStream sortie, PrintStream erreur) {
        return ouvrir(main, sortie, erreur, () -> System.exit(CodeSortie.FAIT));
    }

    /** Comme {@link #ouvrir(Main, PrintStream, PrintStream)}, mais fermer la fenêtre appelle {@code fin}, dans un autre fil. */
    public static Fenetre ouvrir(Main main, PrintStream sortie, PrintStream erreur, Runnable fin) {
        Surveillance surveillance = new Surveillance();
        String fichier = main.getOptions().scene;
        if (fichier != null) {
            surveillance.suivre(fichier);
            main.lireScene(fichier);
            main.avertir(erreur);
        }
        exigerEcran();
        ExecutorService dessins = Executors.newSingleThreadExecutor(new FilDemon("lancer-dessin"));
        Tracage premier = null;
        if (fichier != null) {
            // sans attendre la fenêtre, qui sera plus longue à ouvrir que le brouillon à dessiner
            Dimension taille = new Dimension(main.getOptions().largeur, main.getOptions().hauteur);
            premier = new Tracage(main, null, taille, surveillance, sortie);
            dessins.execute(premier);
        }
        return construire(main, sortie, surveillance, dessins, premier, fin);
    }

    private static Fenetre construire(Main main, PrintStream sortie, Surveillance surveillance, ExecutorService dessins,
            Tracage premier, Runnable fin) {
        List<String> variantes = Variantes.noms();
        Fenetre[] ouverte = new Fenetre[1];
        try {
            EventQueue.invokeAndWait(() -> {
                Dialogues.preparer();
                ouverte[0] = new Fenetre(main, sortie, surveillance, dessins, premier, variantes, fin);
            });
        } catch (InvocationTargetException e) {
            throw new Echec(CodeSortie.PANNE, Main.message(e.getCause()));
        } catch (InterruptedException e) {
            throw new Echec(CodeSortie.PANNE, "interrompu");
        }
        return ouverte[0];
    }

    private static void exigerEcran() {
        boolean ecran;
        try {
            ecran = !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | LinkageError e) {
            // un DISPLAY sans serveur derrière, ou un Java sans ses bibliothèques d'écran
            ecran = false;
        }
        if (!ecran) {
            throw new Echec(CodeSortie.PANNE, "pas d'écran pour ouvrir une fenêtre ; attendu : un écran, ou --image FICHIER.png");
        }
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

    /** Le fichier de la scène montrée, {@code null} s'il n'y en a pas encore. */
    String getFichierMontre() {
        return fichierMontre;
    }

    void choisirScene() {
        File choisi = Dialogues.choisirScene(cadre, fichier);
        if (choisi != null) {
            ouvrirScene(choisi);
        }
    }

    void ouvrirScene(File scene) {
        fichier = scene.getPath();
        titrer();
        panneau.setInvite(null);
        dessiner(true);
    }

    void recharger() {
        if (fichier == null) {
            choisirScene();
        } else {
            dessiner(true);
        }
    }

    void enregistrer() {
        enregistrement.commencer(getImageComplete());
    }

    void arreter() {
        if (enCours) {
            courant.cancel(true);
        }
    }

    /** Termine : plus aucun dessin, plus de fenêtre, et les images en train de s'écrire le seront jusqu'au bout. */
    void fermer() {
        if (fermee) {
            return;
        }
        fermee = true;
        horloge.stop();
        surveillance.terminer();
        annuler();
        dessins.shutdown();
        cadre.dispose();
        enregistrement.terminer(fin);
    }

    /** Dit quelque chose, sans recouvrir ce qui ne va pas dans la scène. */
    void dire(String avis) {
        if (fichierFautif) {
            direEtat(avis);
        } else {
            panneau.getBandeau().avis(avis);
        }
    }

    void direErreur(String erreur) {
        panneau.getBandeau().erreur(erreur);
    }

    void direEtat(String etat) {
        barre.resumer(etat);
    }

    private void fichierChange() {
        EventQueue.invokeLater(() -> dessiner(true));
    }

    /** Recommence le dessin à la taille du panneau ; l'ancienne image reste montrée jusqu'au brouillon de la nouvelle. */
    private void dessiner(boolean relire) {
        boolean lire = relire || courant != null && courant.resteALire();
        Dimension voulue = panneau.getTaillePixels();
        if (fermee || !lire && main.getScene() == null || voulue.width < 1 || voulue.height < 1) {
            return;
        }
        annuler();
        Tracage nouveau = new Tracage(main, lire ? fichier : null, voulue, surveillance, sortie);
        dessins.execute(nouveau);
        suivre(nouveau);
    }

    private void suivre(Tracage tracage) {
        courant = tracage;
        taille = tracage.getTaille();
        enCours = true;
        horloge.start();
        tracage.ensuite(this::finir);
        observer();
    }

    private void annuler() {
        Tracage ancien = courant;
        courant = null;
        if (ancien != null) {
            ancien.cancel(true);
        }
    }

    /** Refait l'image si le panneau n'a plus sa taille, en laissant au brouillon le temps de se montrer. */
    private void suivreTaille() {
        if (panneau.getTaillePixels().equals(taille)) {
            return;
        }
        if (enCours) {
            Lancer lancer = courant.getLancer();
            if (lancer == null || !lancer.isBrouillonFait() && courant.getDureeNs() < PATIENCE_NS) {
                return;
            }
        }
        dessiner(false);
    }

    /** Montre où en est le dessin en cours. */
    private void observer() {
        suivreTaille();
        if (courant == null) {
            return;
        }
        if (courant.vientDeLire()) {
            fichierFautif = false;
            fichierMontre = fichier;
            avertir();
        }
        // l'image d'abord : vue avec le lancer d'après, elle a au moins son brouillon
        ImageMemoire image = main.getImage();
        Lancer lancer = courant.getLancer();
        if (lancer != null) {
            panneau.montrer(image, lancer.isBrouillonFait(), courant.getDureeNs() > PATIENCE_NS);
        }
        barre.avancer(courant);
        montrerPixel();
    }

    /** Le dessin est achevé, arrêté, ou n'a pas pu se faire. */
    private void finir(Tracage tracage) {
        if (tracage != courant || fermee) {
            return;
        }
        enCours = false;
        horloge.stop();
        Throwable panne = tracage.getPanne();
        if (tracage.isAcheve()) {
            complete = main.getImage();
            barre.resumer(tracage);
            if (!fichierFautif) {
                panneau.getBandeau().effacerErreur();
            }
        }
        observer();
        if (panne != null) {
            fichierFautif = panne instanceof SceneFautive;
            direErreur(Main.message(panne));
        }
        // une faute dans la scène a interrompu un dessin de la précédente : c'est lui, la dernière bonne image
        if (fichierFautif && panne != null && complete != panneau.getImage()) {
            dessiner(false);
        }
    }

    /** Montre ce que la scène a de laissé de côté, ou efface le message qui était là. */
    private void avertir() {
        Scene scene = main.getScene();
        panneau.getBandeau().avis(scene == null ? "" : String.join("\n", scene.getAvertissements()));
    }

    private void montrerPixel() {
        barre.montrerPixel(panneau.getPixelSouris(), panneau.getImage());
    }

    private void titrer() {
        String titre = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        cadre.setTitle(fichier == null ? titre : titre + " — " + new File(fichier).getName());
    }
}
