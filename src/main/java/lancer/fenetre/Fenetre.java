package lancer.fenetre;

import java.awt.AWTError;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Toolkit;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.lang.reflect.InvocationTargetException;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import lancer.Lancer;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.lecture.Services;
import lancer.sortie.ImageMemoire;

/**
 * La fenêtre : elle montre l'image pendant que {@link Tracage} la dessine. Le fil des événements ne calcule pas, ne lit
 * pas, n'écrit pas et n'attend pas ; une horloge lui fait regarder trente fois par seconde où en est le dessin.
 */
public final class Fenetre {

    /** Temps entre deux regards sur le dessin en cours, en millisecondes. */
    private static final int PERIODE_MS = 33;

    /** Temps laissé à un brouillon avant de montrer ses morceaux, ou de le refaire à une autre taille, en ns. */
    private static final long PATIENCE_NS = 300_000_000;

    private final Dessinateur dessinateur;
    private final Atelier atelier;
    private final String programme;
    private final Runnable fin;
    private final PanneauImage panneau = new PanneauImage();
    private final Bandeau bandeau = panneau.getBandeau();
    private final BarreEtat barre = new BarreEtat(this::arreterOuRecharger);
    private final JFrame cadre;
    private final Enregistrement enregistrement;
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());

    private String fichier;
    private String fichierMontre;
    private Scene scene;
    private Tracage courant;
    /** Faux seulement quand {@link #finir} est passé : le dessin peut être fini un instant avant qu'on le sache ici. */
    private boolean enCours;
    private ImageMemoire complete;
    private boolean fermee;

    /** @param scene celle qui est déjà lue, {@code null} si aucune ne l'est */
    private Fenetre(Dessinateur dessinateur, Options options, Scene scene, Atelier atelier, String programme,
            Runnable fin) {
        this.dessinateur = dessinateur;
        this.atelier = atelier;
        this.programme = programme;
        this.fin = fin;
        this.scene = scene;
        fichier = options.scene;
        fichierMontre = fichier;
        cadre = new Cadre(menus(), panneau, barre, taille(options));
        enregistrement = new Enregistrement(cadre, bandeau);
    }

    /**
     * Ouvre la fenêtre sur la scène demandée, et revient ; fermer la fenêtre termine le programme, avec le statut 0.
     *
     * @throws SceneFautive si la scène ne peut être utilisée ; rien ne s'est ouvert
     * @throws Echec s'il n'y a pas d'écran
     */
    public static Fenetre ouvrir(Dessinateur dessinateur, Options options) {
        return ouvrir(dessinateur, options, () -> System.exit(CodeSortie.FAIT));
    }

    /** {@link #ouvrir(Dessinateur, Options)}, et fermer la fenêtre appelle {@code fin}, dans un autre fil. */
    public static Fenetre ouvrir(Dessinateur dessinateur, Options options, Runnable fin) {
        Atelier atelier = new Atelier(dessinateur);
        Scene scene = options.scene == null ? null : atelier.lire(options.scene);
        if (scene != null) {
            dessinateur.avertir();
        }
        exigerEcran();
        // sans attendre la fenêtre, plus longue à ouvrir que le brouillon à dessiner
        Tracage premier = scene == null ? null : atelier.dessiner(null, taille(options));
        String variantes = String.join(", ", Services.nomsDesVariantes());
        String programme = variantes.isEmpty() ? "lancer" : "lancer (" + variantes + ")";
        Fenetre[] ouverte = new Fenetre[1];
        try {
            EventQueue.invokeAndWait(() -> {
                Dialogues.preparer();
                ouverte[0] = new Fenetre(dessinateur, options, scene, atelier, programme, fin);
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

    private static Dimension taille(Options options) {
        return new Dimension(options.largeur, options.hauteur);
    }

    private JMenuBar menus() {
        // Ctrl, ou Commande sur un Mac ; la forme en Ex est de Java 10
        int ctrl = Toolkit.getDefaultToolkit().getMenuShortcutKeyMask();
        JMenuBar menus = new JMenuBar();
        JMenu menu = menus.add(new JMenu("Fichier"));
        menu.setMnemonic(KeyEvent.VK_F);
        menu.add(commande("Ouvrir une scène…", KeyEvent.VK_O, ctrl, this::choisirScene));
        menu.add(commande("Enregistrer l'image…", KeyEvent.VK_S, ctrl, this::enregistrer));
        menu.addSeparator();
        menu.add(commande("Quitter", KeyEvent.VK_Q, ctrl, this::fermer));
        menu = menus.add(new JMenu("Dessin"));
        menu.setMnemonic(KeyEvent.VK_D);
        menu.add(commande("Relire la scène et redessiner", KeyEvent.VK_F5, 0, this::recharger));
        // la touche est liée plus bas : Java l'afficherait « Escape »
        menu.add(new Commande("Arrêter (Échap)", null, this::arreter));
        return menus;
    }

    private static Commande commande(String nom, int touche, int avec, Runnable action) {
        return new Commande(nom, KeyStroke.getKeyStroke(touche, avec), action);
    }

    /** @param premier le dessin qu'il y a déjà à montrer, ou {@code null} */
    private void commencer(Tracage premier) {
        ecouter();
        titrer();
        if (premier == null) {
            panneau.setInvite("Ctrl+O pour ouvrir une scène, ou déposer ici un fichier .ini");
            EventQueue.invokeLater(this::choisirScene);
        } else {
            avertir();
            suivre(premier);
        }
        cadre.setVisible(true);
    }

    /** À quoi la fenêtre répond, en plus de ses menus. */
    private void ecouter() {
        atelier.surveiller(() -> EventQueue.invokeLater(() -> dessiner(true)));
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
                suivreTaille();
            }
        });
        // un écran d'une autre densité : les mêmes points, plus ou moins de pixels
        panneau.addPropertyChangeListener("graphicsConfiguration", e -> suivreTaille());
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
        fichier = choisi.getPath();
        titrer();
        panneau.setInvite(null);
        dessiner(true);
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
            dessiner(true);
        }
    }

    private void enregistrer() {
        ImageMemoire image = getImageComplete();
        if (image == null) {
            bandeau.avis(enCours ? "L'image se dessine encore : elle pourra être enregistrée une fois achevée."
                    : "Pas d'image achevée à enregistrer ; F5 pour la dessiner.");
        } else {
            enregistrement.commencer(image, fichierMontre);
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
        atelier.terminer();
        cadre.dispose();
        enregistrement.terminer(fin);
    }

    /** Recommence le dessin à la taille du panneau ; l'ancienne image reste jusqu'au brouillon de la nouvelle. */
    private void dessiner(boolean relire) {
        boolean lire = relire || courant != null && courant.resteALire();
        Dimension voulue = panneau.getTaillePixels();
        if (fermee || !lire && scene == null || voulue.width < 1 || voulue.height < 1) {
            return;
        }
        if (courant != null) {
            courant.arreter();
        }
        suivre(atelier.dessiner(lire ? fichier : null, voulue));
    }

    private void suivre(Tracage tracage) {
        courant = tracage;
        enCours = true;
        horloge.start();
        observer();
    }

    /** Refait l'image si le panneau n'a plus sa taille, en laissant au brouillon le temps de se montrer. */
    private void suivreTaille() {
        if (courant == null || panneau.getTaillePixels().equals(courant.getTaille())) {
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
        boolean fini = courant.isFini();
        Scene lue = courant.getLue();
        if (lue != null && lue != scene) {
            scene = lue;
            fichierMontre = fichier;
            avertir();
        }
        // l'image d'abord : vue avec le lancer d'après, elle a au moins son brouillon
        ImageMemoire image = dessinateur.getImage();
        Lancer lancer = courant.getLancer();
        if (lancer != null) {
            panneau.montrer(image, lancer.isBrouillonFait(), courant.getDureeNs() > PATIENCE_NS);
        }
        barre.avancer(courant);
        montrerPixel();
        if (fini && enCours) {
            finir();
        }
    }

    /** Le dessin est achevé, arrêté, ou n'a pas pu se faire. */
    private void finir() {
        enCours = false;
        horloge.stop();
        Throwable panne = courant.getPanne();
        if (courant.isAcheve()) {
            complete = dessinateur.getImage();
            barre.resumer(courant.getLancer());
            bandeau.effacerErreur();
            String ecart = courant.getLancer().getTemoignage().ecart;
            if (ecart != null) {
                bandeau.avis(ecart);
            }
        } else if (panne instanceof SceneFautive) {
            bandeau.faute(Pannes.message(panne));
            if (complete != panneau.getImage()) {
                // la faute a interrompu un dessin de la scène d'avant : c'est lui, la dernière bonne image
                dessiner(false);
            }
        } else if (panne != null) {
            bandeau.erreur(Pannes.message(panne));
        }
    }

    /** Montre ce que la scène, sans faute, a de laissé de côté, à la place du message qui était là. */
    private void avertir() {
        bandeau.faute("");
        bandeau.avis(String.join("\n", dessinateur.getAvertissements()));
    }

    private void montrerPixel() {
        barre.montrerPixel(panneau.getPixelSouris(), panneau.getImage());
    }

    private void titrer() {
        cadre.setTitle(fichier == null ? programme : programme + " — " + new File(fichier).getName());
    }
}
