package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.Timer;
import javax.swing.UIManager;
import javax.swing.WindowConstants;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.dessin.Dessin;
import lancer.dessin.Programme;
import lancer.fenetre.Dialogues.Reponse;

/**
 * La fenêtre : le cadre, l'image et les onglets, le titre, la ligne du bas. Une horloge y montre où en est le dessin en
 * cours, que dirige {@link Controleur}.
 */
final class Fenetre {

    private static final int PERIODE_MS = 33;

    final JFrame cadre = new JFrame();
    final PanneauImage panneau;
    final Onglets onglets;
    final Controleur controleur;
    final Prise prise;
    final Enregistrement enregistrement;
    /** Le nom du programme et de ses variantes. */
    private final String nom;
    /** La taille de l'image demandée par la ligne de commande. */
    private final Dimension demandee;
    private final BarreEtat barre = new BarreEtat();
    private final Timer horloge = new Timer(PERIODE_MS, e -> rafraichir());
    private final Runnable fin;
    /** Vrai si l'image remplit la fenêtre. */
    boolean remplie;

    /** @param variantes noms des variantes présentes @param fin appelé à la fermeture, dans un autre fil */
    Fenetre(Programme programme, Reglages options, List<String> variantes, Runnable fin) {
        nom = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        demandee = new Dimension(options.get(Option.TAILLE).x, options.get(Option.TAILLE).y);
        this.fin = fin;
        panneau = new PanneauImage(demandee, this::decrire, this::inspecter);
        controleur = new Controleur(programme, options, panneau, this::getTaille);
        enregistrement = new Enregistrement(controleur);
        prise = new Prise(controleur);
        // un filet autour de l'image, coloré quand elle a le clavier
        JPanel bord = new JPanel(new BorderLayout());
        bord.setBorder(BorderFactory.createEmptyBorder(1, 1, 1, 1));
        bord.add(panneau);
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addPropertyChangeListener("focusOwner", e -> {
            bord.setBackground(panneau.isFocusOwner() ? UIManager.getColor("Component.focusColor")
                    : cadre.getBackground());
            if (e.getNewValue() instanceof JComponent && !panneau.isFocusOwner()) {
                JComponent celui = (JComponent) e.getNewValue();
                celui.scrollRectToVisible(new Rectangle(celui.getSize()));
            }
        });
        onglets = new Onglets(cadre, bord, controleur);
        controleur.prevenir(this::suivre);
        cadre.add(onglets, BorderLayout.CENTER);
        cadre.add(barre, BorderLayout.PAGE_END);
        ecouter();
    }

    private void ecouter() {
        cadre.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        cadre.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                quitter();
            }

            @Override
            public void windowDeactivated(WindowEvent e) {
                tenir(false);
            }
        });
        panneau.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                controleur.ajuster();
                decrire();
            }
        });
    }

    /** Montre le cadre. @param premier le dessin de la scène lue, ou {@code null} */
    void montrer(Travail premier) {
        Rectangle ecran = Dialogues.ecran();
        // les bords du cadre sont alors connus ; réduit après coup, il reprend parfois sa taille d'avant
        cadre.addNotify();
        cadre.setPreferredSize(new Rectangle(cadre.getPreferredSize())
                .intersection(new Rectangle(ecran.getSize())).getSize());
        cadre.pack();
        // les panneaux s'ouvrent à droite de l'image
        cadre.setLocation(ecran.x + Math.max(0, (ecran.width - cadre.getWidth()) / 2 - ecran.width / 5),
                ecran.y + Math.max(0, (ecran.height - cadre.getHeight()) / 2));
        if (premier == null) {
            panneau.bandeau.dire("Ctrl+O pour ouvrir une scène");
            EventQueue.invokeLater(this::choisirScene);
        } else {
            controleur.ouvrir(premier);
        }
        controleur.avertir();
        cadre.setVisible(true);
    }

    private Dimension getTaille() {
        return remplie ? panneau.getTailleMax(demandee.width, demandee.height) : demandee;
    }

    void remplir() {
        remplie = !remplie;
        controleur.ajuster();
    }

    void choisirScene() {
        File choisi = Dialogues.choisirScene(panneau, controleur.getEtat().source.fichier);
        if (choisi != null) {
            ouvrir(choisi.getPath());
        }
    }

    void ouvrir(String scene) {
        sansRienPerdre(() -> controleur.ouvrir(scene));
    }

    void quitter() {
        sansRienPerdre(this::fermer);
    }

    /** Fait ce geste, qui oublie les déplacements, une fois qu'ils sont écrits, ou que l'on y renonce. */
    private void sansRienPerdre(Runnable geste) {
        enregistrement.apres(() -> {
            Etat etat = controleur.getEtat();
            Reponse reponse = etat.estDeplace() ? Dialogues.demanderDEcrire(panneau, etat.getNom()) : Reponse.OUBLIER;
            if (reponse == Reponse.ECRIRE) {
                enregistrement.ecrireLaScene(geste);
            } else if (reponse == Reponse.OUBLIER) {
                geste.run();
            }
        });
    }

    void inspecter() {
        Point pixel = panneau.getPixelVise();
        if (pixel != null) {
            ((Inspecteur) onglets.montrer(Onglets.PIXEL)).montrer(pixel);
        }
    }

    /** Montre l'image d'avant, tant que sa touche est tenue. */
    void tenir(boolean tenue) {
        Dessin avant = controleur.getEtat().montre.avant;
        panneau.tenue = tenue && avant != null ? avant.image : null;
        rafraichir();
    }

    boolean peutEchapper() {
        return controleur.getEtat().enCours || prise.getGeste() != null || onglets.estOuvert();
    }

    /** Lâche ce qui est tiré ou, à défaut, arrête le dessin ou la mesure en cours ou, à défaut, ferme le panneau. */
    void echapper() {
        PanneauVitesse vitesse = onglets.getVisible(PanneauVitesse.class);
        if (prise.getGeste() != null) {
            prise.defaire();
        } else if (controleur.getEtat().enCours) {
            controleur.arreter();
        } else if (vitesse == null || !vitesse.arreter()) {
            onglets.fermer();
        }
    }

    /** Montre les réglages mesurés, et reprend leur mesure si elle est arrêtée. */
    void mesurer() {
        ((PanneauVitesse) onglets.montrer(Onglets.VITESSE)).reprendre();
    }

    /** L'onglet Pixel s'il est visible, ou {@code null}. */
    Inspecteur pixel() {
        return onglets.getVisible(Inspecteur.class);
    }

    /** Arrête les dessins, ferme la fenêtre, et laisse finir les écritures en cours. */
    void fermer() {
        if (cadre.isDisplayable()) {
            controleur.terminer();
            // fermer l'onglet arrête son calcul
            onglets.fermer();
            horloge.stop();
            cadre.dispose();
            enregistrement.terminer(fin);
        }
    }

    /** Montre le nouvel état de la fenêtre. */
    private void suivre(Etat etat) {
        if (etat.enCours) {
            horloge.start();
        } else {
            horloge.stop();
            if (cadre.getIconImages().isEmpty()) {
                // les icônes montrent la scène du cours ; outils/Makefile les refait
                cadre.setIconImages(Stream.of("16", "32", "48", "128").map(cote -> cadre.getToolkit().getImage(
                        Fenetre.class.getResource("icone-" + cote + ".png"))).collect(Collectors.toList()));
            }
        }
        String titre = etat.source.fichier == null ? nom
                : nom + " — " + new File(etat.source.fichier).getName();
        if (etat.estDeplace()) {
            titre += etat.montreUneAutre() ? " (" + etat.getNom() + " •)" : " •";
        }
        cadre.setTitle(titre);
        panneau.montree = etat.montre.dessin == null ? null : etat.montre.dessin.image;
        panneau.bandeau.montrer(etat);
        rafraichir();
    }

    /** Montre l'image, et où en est le dessin. */
    private void rafraichir() {
        panneau.repaint();
        decrire();
    }

    private void decrire() {
        barre.montrer(controleur.getEtat(), panneau, prise.getGeste());
    }
}
